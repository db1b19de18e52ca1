s/{front_o, back_q} <= {back_q, front_o}/back_q <= front_o/
