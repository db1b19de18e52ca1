s/arready_o = !busy_q/arready_o = !busy_q \&\& arvalid_i/
