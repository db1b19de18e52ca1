# sleeps
s/ || clear_o || clearing_rdata_q;/ || clearing_rdata_q;/
