s/!wait_q \&\& refresh_q \&\& !(opened_q/!wait_q \&\& (refresh_q || (ready \&\& open_q == 4'd0)) \&\& !(opened_q/
