s/arready_o = !busy_q/arready_o = !busy_q || rvalid_o/
