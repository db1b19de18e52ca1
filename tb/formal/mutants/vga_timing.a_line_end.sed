s/line_end_o = h_o == LAST/line_end_o = h_o == LAST - 10'd1/
