s/{PARTS{wdata_i}}/{{TO-FROM{1'b0}}, wdata_i}/
