s/awready_o = !busy_q/awready_o = !busy_q \&\& awvalid_i/
