s/data ? readdata_i/data ? ~readdata_i/
