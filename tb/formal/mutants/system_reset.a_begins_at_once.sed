s/ or posedge rst_i//
