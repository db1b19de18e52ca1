# sleeps
s/restart_o || send_o || waits_q;/restart_o || waits_q;/
