s/vga_r_o <= visible ?/vga_r_o <= 1'b1 ?/
