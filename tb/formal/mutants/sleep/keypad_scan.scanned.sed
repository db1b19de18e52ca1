# sleeps
s/ || scanned_q//
