s/swap_i \&\& swap_q/swap_i/
