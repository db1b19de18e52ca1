s/vga_blank_no} <= sync_q\[8:6\]/vga_blank_no} <= sync_q[5:3]/
