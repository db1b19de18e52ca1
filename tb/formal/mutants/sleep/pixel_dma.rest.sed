# rests
s/busy_q ? {9'd0, odd_i}/busy_q ? 10'd1/
