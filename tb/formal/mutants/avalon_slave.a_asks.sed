s/acts \&\& !write_i \&\& clock_q >= SETUP/acts \&\& clock_q >= SETUP/
