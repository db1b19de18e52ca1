# sleeps
s/^ *|| dram_dq_oe_o;/;/
