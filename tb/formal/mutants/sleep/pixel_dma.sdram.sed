# rests
s/awake_o = busy_q \&\& sdram_q/awake_o = busy_q \&\& sdram_req_o/
