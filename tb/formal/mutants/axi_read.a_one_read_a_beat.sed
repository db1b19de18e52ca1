s/re_o     <= serve/re_o     <= 1/
