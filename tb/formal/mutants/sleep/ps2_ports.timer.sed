# sleeps
s/ || timer_q != 14'd0$//
