s/next_count(push_i \&\& !count_o\[DEPTH_LOG2\],/next_count(push_i,/
