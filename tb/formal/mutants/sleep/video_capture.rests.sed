s/ || !rests_q;/;/
