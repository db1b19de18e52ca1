# sleeps
s/ || screen_q != 4.d0;/;/
