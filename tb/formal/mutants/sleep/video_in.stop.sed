# sleeps
s/ || ((run_q || begun_q) \&\& !enable_i);/;/
