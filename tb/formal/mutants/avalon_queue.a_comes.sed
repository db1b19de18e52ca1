s/assign valid_o = .*/assign valid_o = 1'b0;/
