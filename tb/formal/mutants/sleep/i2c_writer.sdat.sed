s/ || sdat_awake;/;/
