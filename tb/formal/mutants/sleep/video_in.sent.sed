# decoder sleeps
s/ || sent_awake;/;/
