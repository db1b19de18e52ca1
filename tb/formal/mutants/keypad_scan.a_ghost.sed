s/ghost_o <= rectangle(last_q)/ghost_o <= two_common(last_q[3:0], last_q[7:4])/
