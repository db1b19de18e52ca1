# sleeps
s/ || cell_we_o != 4'd0$//
