# sleeps
s/awake_o = rdata_o != 32'd0/awake_o = 1'b0/
