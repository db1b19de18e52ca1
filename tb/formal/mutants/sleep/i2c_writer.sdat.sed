# sleeps
s/ || sdat_awake;/;/
