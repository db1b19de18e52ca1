s/edge_q \& mask_q/edge_q | mask_q/
