# sleeps
s/ || (take_q && write_count != 7'd0)//
