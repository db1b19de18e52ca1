s/due_q - now_i\[4:0\] - 5'd1/due_q - now_i[4:0]/
