# rests
s/(h\[0\] || text_q)/1'b1/
