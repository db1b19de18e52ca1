s/: pixel;/: !flat_q ? pixel : 16'd0;/; s/draws \&\& !flat_q/draws/
