# sleeps
s/ || write_count != 7'd0//
