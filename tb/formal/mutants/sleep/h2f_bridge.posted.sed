# sleeps
s/ || posted != 2'd0 || we_o/ || we_o/
