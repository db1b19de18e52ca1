s/ || refresh_q$//
