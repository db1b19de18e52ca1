s/else sclk_o <= 1'b1;/else begin sclk_o <= 1'b1; if (ack_cell) sdat_oe_o <= 1'b1; end/
