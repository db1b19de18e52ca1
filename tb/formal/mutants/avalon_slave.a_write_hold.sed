s/ \&\& !held;/;/
