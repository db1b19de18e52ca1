s/ \&\& !(we_i \&\& pipe_q != 3'd0)//
