s/!wait_q \&\& refresh_q \&\& !(opened_q/!wait_q \&\& (refresh_q || step_q == CLOSE) \&\& !(opened_q/
