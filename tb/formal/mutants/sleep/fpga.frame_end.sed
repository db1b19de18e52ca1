s/ || re != 20'd0 || frame_end$/ || re != 20'd0/
