s/= may \&\& (hit_i/= (hit_i/
