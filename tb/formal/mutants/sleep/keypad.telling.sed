# sleeps
s/ || telling$//
