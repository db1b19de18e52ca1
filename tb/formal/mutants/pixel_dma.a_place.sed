s/windex_o = {parity_q, got_q}/windex_o = {parity_q, asked_q}/
