s/!= FULL/!= FULL \&\& read_seen_q == 0/
