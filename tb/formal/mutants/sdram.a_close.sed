s/go    = !wait_q \&\& ready/go    = ready/
