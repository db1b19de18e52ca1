s/vga_r_o <= sync_q\[6\] ?/vga_r_o <= 1'b1 ?/
