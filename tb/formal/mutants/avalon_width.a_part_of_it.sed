s/write_o = write_i/write_o = 1'b1/
