s/equal_q >= debounce_i/equal_q > debounce_i/
