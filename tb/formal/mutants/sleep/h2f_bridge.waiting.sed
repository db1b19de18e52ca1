# sleeps
s/|| re || rdram_q || re_o/|| re || re_o/
