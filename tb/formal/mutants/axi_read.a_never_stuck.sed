s/re_o     <= !rlast_o \&\& !refuse_q/re_o     <= 0/
