s/we_o    <= !refuse_q/we_o    <= 1/
