s/drain_q\[1\] \&\& !hold_i) bvalid_o/drain_q[1]) bvalid_o/
