s/begun_q <= now_i\[9:0\] + 10'd1/begun_q <= now_i[9:0]/
