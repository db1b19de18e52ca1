# sleeps
s/run_i != runs_q || //
