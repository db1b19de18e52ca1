s/acts \&\& !write_i \&\& clock_q >= SETUP/acts \&\& !write_i/
