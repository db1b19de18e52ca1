s/pop_i \&\& !empty_o/pop_i/
