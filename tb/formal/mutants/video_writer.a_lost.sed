s/ \&\& !(sdram_req_o \&\& !sdram_take_i);/;/;s/^                          \&\& !(sdram_req_o/                          \&\& !(1'b0 \&\& sdram_req_o/
