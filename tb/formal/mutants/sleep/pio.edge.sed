# sleeps
s/ || data != data_was_q;/;/
