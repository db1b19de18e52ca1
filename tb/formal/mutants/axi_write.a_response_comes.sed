s/if (drain_q\[1\]) bvalid_o/if (drain_q[1] \&\& bready_i) bvalid_o/
