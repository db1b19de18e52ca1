s/rdata_q <= rvalid_o ? {FROM{1'b0}} : rdata/rdata_q <= {FROM{1'b0}}/
