s/screen_valid_o = valid \&\& screen_q\[3\]/screen_valid_o = valid \&\& screen_q[2]/
