s/address_i\[32\*turn +: 32\]/address_i[31:0]/
