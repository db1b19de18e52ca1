# sleeps
s/ || refresh_q$//
