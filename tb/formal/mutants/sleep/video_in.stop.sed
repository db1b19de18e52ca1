# sleeps
s/ || (run_q \&\& !enable_i);/;/
