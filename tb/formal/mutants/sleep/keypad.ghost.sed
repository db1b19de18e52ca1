s/ || (ghost \&\& !ghost_q);/;/
