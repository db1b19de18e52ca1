# sleeps
s/ || granted_q;/;/
