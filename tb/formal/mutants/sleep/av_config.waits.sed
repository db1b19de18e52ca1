# sleeps
s/send_o || waits_q;/send_o;/
