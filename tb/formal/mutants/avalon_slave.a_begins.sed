s/acts \&\& clock_q == 8'd0/acts/
