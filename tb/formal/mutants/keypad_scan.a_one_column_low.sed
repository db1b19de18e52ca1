s/4'b0001 << col_q/4'b0011 << col_q/
