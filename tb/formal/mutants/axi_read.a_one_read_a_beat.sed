s/re_o     <= serves(arburst_i, arsize_i)/re_o     <= 1/
