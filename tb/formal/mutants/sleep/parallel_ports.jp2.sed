# sleeps
s/awake != 6'd0/awake[4:0] != 5'd0/
