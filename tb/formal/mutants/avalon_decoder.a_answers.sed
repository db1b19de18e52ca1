s/rvalid_o = rvalid_i != /rvalid_o = rvalid_i == /
