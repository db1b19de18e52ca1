# sleeps
s/ || frame//
