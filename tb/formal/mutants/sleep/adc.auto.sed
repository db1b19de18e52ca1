# sleeps
s/asked_q || auto_q || rdata/asked_q || rdata/
