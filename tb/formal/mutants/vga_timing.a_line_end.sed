s/line_end_o = h_o == .*/line_end_o = h_o == H_TOTAL - 10'd2;/
