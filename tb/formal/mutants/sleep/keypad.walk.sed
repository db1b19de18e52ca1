# sleeps
s/|| walk_q != 4'd0 //
