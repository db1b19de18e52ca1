# clocks.h2f_group sleeps
s/ || cells_clear || cell_fetch)/ || cells_clear)/
