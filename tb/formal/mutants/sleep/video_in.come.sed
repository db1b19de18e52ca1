# sleeps
s/ || come_awake//
