s/assign sdram_req_o  = !none \&\& belongs \&\& sdram;/assign sdram_req_o  = !none \&\& belongs \&\& !onchip;/
