s/if (we_i \&\& waddr_i\[3:0\] == PIXEL_STATUS\[3:0\] \&\& wstrb_i\[0\])/if (we_i \&\& waddr_i[3:0] == PIXEL_STATUS[3:0])/
