s/vga_r_o <= sync3_q\[0\] ?/vga_r_o <= 1'b1 ?/
