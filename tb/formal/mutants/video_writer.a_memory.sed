s/assign sdram_req_o  = go \&\& belongs \&\& !onchip;/assign sdram_req_o  = go \&\& belongs;/
