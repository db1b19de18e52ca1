# rests
s/h - h_o - 10'd1/h - h_o/
