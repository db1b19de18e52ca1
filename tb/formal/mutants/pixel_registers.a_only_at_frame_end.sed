s/wire swap_now = .*/wire swap_now = swap_q;/
