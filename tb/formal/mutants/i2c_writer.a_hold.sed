s/sclk_o <= 1'b0;$/begin sclk_o <= 1'b0; sdat_oe_o <= 1'b0; end/
