# sleeps
s/auto_q || read_q || rdata/auto_q || rdata/
