s/wire push = push_i \&\& !full_o;/wire push = push_i;/
