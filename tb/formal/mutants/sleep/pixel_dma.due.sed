# sleeps
s/ || (busy_q \&\& odd_i);/;/
