# sleeps
s/waits_i || busy_q;/waits_i;/
