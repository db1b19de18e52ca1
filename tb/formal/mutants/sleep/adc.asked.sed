# sleeps
s/busy_q || asked_q || auto_q/busy_q || auto_q/
