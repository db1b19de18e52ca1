s/rvalid_i \&\& lasts_q\[first_q\]/rvalid_i \&\& (lasts_q[first_q] || write_i)/
