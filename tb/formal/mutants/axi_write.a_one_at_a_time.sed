s/awready_o = !busy_q/awready_o = !busy_q || drain_q[1]/
