# sleeps
s/busy_o || done_o/busy_o/
