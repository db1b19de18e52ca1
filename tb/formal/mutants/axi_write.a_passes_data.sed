s/wstrb_o <= wstrb_i/wstrb_o <= 15/
