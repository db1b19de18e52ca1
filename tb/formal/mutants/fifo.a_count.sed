s/next_count(push_i \&\& !full_o,/next_count(push_i,/
