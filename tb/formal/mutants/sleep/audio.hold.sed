# sleeps
s/awake_o(fifos_awake\[2\])/awake_o()/; s/fifos_awake != 4'd0/{fifos_awake[3], fifos_awake[1:0]} != 3'd0/
