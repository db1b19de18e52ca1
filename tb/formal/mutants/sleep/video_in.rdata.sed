# sleeps
s/ || edges_rdata_q || / || /
