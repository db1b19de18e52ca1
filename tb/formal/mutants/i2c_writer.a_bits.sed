s/sdat_oe_o <= !bits_q\[26\]/sdat_oe_o <= bits_q[26]/
