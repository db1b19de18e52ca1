s/wire swap_now = .*/wire swap_now = frame_end_i;/
