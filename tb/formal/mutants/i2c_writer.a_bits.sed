s/else sclk_o <= 1'b1;/else begin sclk_o <= 1'b1; sdat_oe_o <= bits_q[26]; end/
