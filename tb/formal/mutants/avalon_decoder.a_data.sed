s/assign rdata = slave\[n - 1\].rdata/assign rdata = {WIDTH{1'b0}}/
