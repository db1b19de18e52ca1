s/rdata_o <= words\[rindex_i\]/rdata_o <= words[rindex_i[7:0]]/
