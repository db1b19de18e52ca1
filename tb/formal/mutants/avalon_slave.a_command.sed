s/byteenable_o    = be_i/byteenable_o    = ~be_i/
