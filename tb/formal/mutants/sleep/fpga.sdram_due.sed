# clocks.memory_group sleeps
s/sdram_awake || sdram_due$/sdram_awake/
