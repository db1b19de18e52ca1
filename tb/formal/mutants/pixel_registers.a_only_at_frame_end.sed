s/frame_end_i \&\& swap_q/swap_q/g
