s/rerror_i ? 32'd0 : rdata_i/rdata_i/
