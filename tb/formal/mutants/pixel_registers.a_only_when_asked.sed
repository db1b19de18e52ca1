s/frame_end_i \&\& swap_q/frame_end_i/g
