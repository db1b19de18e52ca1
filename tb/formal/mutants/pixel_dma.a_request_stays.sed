s/= more \&\& in_sdram;/= more \&\& in_sdram \&\& !sdram_valid_i;/
