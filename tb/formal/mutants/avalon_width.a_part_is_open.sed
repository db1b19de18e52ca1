s/ \&\& !done_q\[n\]//
