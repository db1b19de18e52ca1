# sleeps
s/ || sent_awake//
