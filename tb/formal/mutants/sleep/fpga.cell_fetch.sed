s/ || cells_clear || cell_fetch)/ || cells_clear)/
