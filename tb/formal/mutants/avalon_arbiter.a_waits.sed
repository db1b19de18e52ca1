s/n > turn_q \&\&/n != 1 \&\&/
