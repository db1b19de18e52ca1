s/hit_i == slave_q \&\& //
