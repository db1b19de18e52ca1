s/vga_blank_no} <= sync3_q/vga_blank_no} <= sync2_q/
