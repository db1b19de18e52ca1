# sleeps
s/ || asked_q || done_q;/ || asked_q;/
