s/rst_o = line_q\[1\]/rst_o = line_q[1] \&\& clk_i/
