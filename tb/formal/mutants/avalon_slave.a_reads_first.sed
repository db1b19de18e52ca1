s/(write_i || !known ? pending_q/(!known ? pending_q/
