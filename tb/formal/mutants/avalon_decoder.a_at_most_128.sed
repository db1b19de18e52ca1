s/ \&\& pending_q != MOST//
