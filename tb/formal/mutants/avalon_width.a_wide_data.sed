s/rdata_i\[FROM\*answered +: FROM\]/rdata_i[FROM-1:0]/
