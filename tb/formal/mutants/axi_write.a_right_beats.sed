s/if (left_q == 4'd0) begin/if (left_q <= 4'd1) begin/
