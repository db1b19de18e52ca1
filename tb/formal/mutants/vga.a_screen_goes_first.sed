s/rgrant_o = !screen_re_i/rgrant_o = 1'b1/
