s/read ^ read >> 1/read/
