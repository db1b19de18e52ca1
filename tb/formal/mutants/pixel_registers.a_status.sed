s/enable_o, STATUS\[1\], swap_q}/enable_o, 1'b1, swap_q}/
