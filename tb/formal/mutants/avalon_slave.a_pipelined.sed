s/: clock_q == last;/: clock_q == last + 8'd1;/
