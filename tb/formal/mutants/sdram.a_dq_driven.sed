s/dram_dq_oe_o  <= 1'b1/dram_dq_oe_o  <= wstrb_i != 4'd0/
