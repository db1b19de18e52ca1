s/2'd0:$/2'd0: if (cell_q == STOP) sclk_o <= 1'b1; else/
