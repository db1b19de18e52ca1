s/{addr_q\[ADDR_W-1:2\], 2.b00}/addr_q/
