# sleeps
s/start || restart_q ||/start ||/
