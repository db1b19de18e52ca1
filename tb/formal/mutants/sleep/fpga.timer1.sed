# rests
s/least(timer0_rest_i, timer1_rest_i)/timer0_rest_i/
