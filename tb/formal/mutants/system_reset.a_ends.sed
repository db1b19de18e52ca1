s/{line_q\[0\], 1'b0}/{2{line_q[0]}}/
