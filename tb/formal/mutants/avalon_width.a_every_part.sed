s/last      = .*/last      = 1'b1;/
