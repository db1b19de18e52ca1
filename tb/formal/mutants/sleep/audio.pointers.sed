# sleeps
s/{count_o, write_q, read_q} != .*/count_o != 0;/
