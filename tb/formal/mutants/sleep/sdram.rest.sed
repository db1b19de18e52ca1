# rests
s/left\[9:0\] - 10'd1/left[9:0]/
