s/pending_q != MOST)/pending_q != MOST \&\& !readdatavalid_i)/
