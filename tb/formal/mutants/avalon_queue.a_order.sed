s/words_q\[written_q/words_q[read_q/
