# rests
s/5'd31 - now_i/5'd0 - now_i/
