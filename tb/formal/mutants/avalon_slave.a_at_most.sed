s/: pending_q != MOST)/: 1'b1)/
