# sleeps
s/asked_q || auto_q || read_q/asked_q || read_q/
