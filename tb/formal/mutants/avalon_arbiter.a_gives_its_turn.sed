s/left_q <= left_q - {7'd0, taken}/left_q <= left_q/
