s/enable_o, consecutive_o, swap_q}/enable_o, 1'b0, swap_q}/
