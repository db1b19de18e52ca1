s/cell_q == STOP) begin/cell_q == 5'd26) begin/
