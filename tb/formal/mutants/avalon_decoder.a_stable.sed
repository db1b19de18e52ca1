s/valid_i \&\& may ? hit_i/valid_i \&\& may \&\& !rvalid_o ? hit_i/
