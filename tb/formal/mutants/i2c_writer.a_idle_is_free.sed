s/sclk_o    <= 1'b1/sclk_o    <= 1'b0/
