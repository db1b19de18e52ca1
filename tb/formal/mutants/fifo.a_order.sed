s/wire  *pass  *= .*/wire pass = push \&\& empty_o;/
