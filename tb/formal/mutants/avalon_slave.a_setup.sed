s/chipselect_o    = acts/chipselect_o    = acts \&\& clock_q >= SETUP/
