s,address_i / TO_BYTES \* TO_BYTES,address_i,
