s/shown != 5'd0 \&\& //
