s/if (drain_q\[1\]) bvalid_o/if (wready_o) bvalid_o/
