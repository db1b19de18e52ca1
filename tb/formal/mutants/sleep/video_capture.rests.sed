# sleeps
s/ || !rests_q;/;/
