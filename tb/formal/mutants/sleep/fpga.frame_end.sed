# clocks.ports_group sleeps
s/ || re != 32'd0 || frame_end$/ || re != 32'd0/
