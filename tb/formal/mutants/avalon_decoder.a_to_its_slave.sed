s/= valid_i \&\& may ? hit_i/= may ? hit_i/
