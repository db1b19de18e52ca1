s/found \&\& pending_q != MOST/pending_q != MOST/
