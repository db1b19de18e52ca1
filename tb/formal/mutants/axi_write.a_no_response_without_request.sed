s/if (drain_q\[1\] \&\& !hold_i) bvalid_o/if (wready_o) bvalid_o/
