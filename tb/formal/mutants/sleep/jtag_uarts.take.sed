# sleeps
s/ || takes / /
