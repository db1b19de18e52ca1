s/ready_i \&\& valid_o \&\& last/ready_i \&\& last/
