s/if (drain_q\[1\] \&\& !hold_i) bvalid_o/if (drain_q[1] \&\& !hold_i \&\& bready_i) bvalid_o/
