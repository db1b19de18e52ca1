# sleeps
s/ || {clk_q, dat_q} != meta_q;/;/
