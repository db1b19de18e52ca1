s/address = {4'd0, index_i\[8:0\]} << 1/address = {4'd1, index_i[8:0]} << 1/
