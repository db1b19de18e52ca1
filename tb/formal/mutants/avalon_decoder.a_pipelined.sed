s/hit_i == slave_q/1'b0/
