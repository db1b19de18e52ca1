s/first \&\& !begun_q/first/
