# sleeps
s/awake_o = filling_q/awake_o = 1'b0/
