s/pending_q != MOST/pending_q == 0/
