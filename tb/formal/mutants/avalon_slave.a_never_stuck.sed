s/pending_q != MOST)/pending_q == 8'd0)/
