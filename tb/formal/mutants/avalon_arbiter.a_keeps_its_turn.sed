s/found = valid_i\[turn_q\] \&\& left_q != 8'd0/found = 1'b0/
