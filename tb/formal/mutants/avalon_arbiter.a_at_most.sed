s/found \&\& pending_q != MOST/found/
