s/if (re_i) rdata_o/rdata_o/
