s/push_i \&\& !full_o/push_i/
