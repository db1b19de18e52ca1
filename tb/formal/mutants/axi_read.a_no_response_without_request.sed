s/rvalid_o <= !rlast_o \&\& refuse_q/rvalid_o <= refuse_q/
