# sleeps
s/restart_o || send_o;/restart_o;/
