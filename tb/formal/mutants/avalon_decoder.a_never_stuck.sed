s/pending_q == 8'd0 ||/pending_q == 8'd1 ||/
