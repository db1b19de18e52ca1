s/enable_i ? pixel : 16'd0/enable_i \&\& !flat_q ? pixel : 16'd0/; s/draws \&\& !flat_q/draws/
