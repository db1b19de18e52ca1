s/: x_q != WORDS/: 1'b1/
