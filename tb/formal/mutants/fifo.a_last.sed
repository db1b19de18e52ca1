s/end else if (pop \&\& count_o != ONE) begin/end else if (pop) begin/
