# sleeps
s/ || sent_o//
