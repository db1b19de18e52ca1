s/equal_q >= debounce_i/equal_q + 8'd1 >= debounce_i/
