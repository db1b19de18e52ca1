s/full_o  = count_o\[DEPTH_LOG2\]/full_o  = \&count_o[DEPTH_LOG2-1:0]/
