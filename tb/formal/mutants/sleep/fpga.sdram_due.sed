s/sdram_awake || sdram_due$/sdram_awake/
