s/HAS_A != 0 \&\& wdata_i/wdata_i/
