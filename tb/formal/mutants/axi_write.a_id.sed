s/bid_o    <= awid_i/bid_o    <= ~awid_i/
