s/pending_q != MOST/pending_q != MOST \&\& !rvalid_i/
