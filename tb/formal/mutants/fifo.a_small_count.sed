s/push_i \&\& count_o != FULL/push_i/
