# sleeps
s/ || (ghost \&\& !ghost_q);/;/
