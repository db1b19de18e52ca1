s/ || granted_q;/;/
