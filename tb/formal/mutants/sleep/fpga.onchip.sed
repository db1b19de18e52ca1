# clocks.memory_group sleeps
s/fetch_awake || onchip_we != 4'd0 ||/fetch_awake ||/
