s/data   = readdatavalid_i/data   = readdatavalid_i \&\& runs/
