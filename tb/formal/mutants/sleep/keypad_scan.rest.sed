# rests
s/left - 1 : 10'd1023/left : 10'd1023/
