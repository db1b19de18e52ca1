s/clock_q >= SETUP \&\& !waitrequest_i/clock_q >= SETUP/
