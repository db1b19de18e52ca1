s/ \&\& turn == m;/;/
