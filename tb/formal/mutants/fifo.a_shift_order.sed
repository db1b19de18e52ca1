s/left(pop_i) == n/count_o == n/
