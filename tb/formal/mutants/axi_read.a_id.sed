s/rid_o    <= arid_i/rid_o    <= ~arid_i/
