s/rlast_o   = left_q == 4'd0/rlast_o   = left_q <= 4'd1/
