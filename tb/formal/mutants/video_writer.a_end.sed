s/x_q == WORDS - 8.d1;/x_q == WORDS;/
