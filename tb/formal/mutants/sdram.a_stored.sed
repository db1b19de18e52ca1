s/high_mask_q   <= ~wstrb_i\[3:2\]/high_mask_q   <= ~wstrb_i[1:0]/
