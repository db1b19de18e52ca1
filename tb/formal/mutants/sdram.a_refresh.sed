s/command = open_q != 4'd0 || step_q == CLOSE ?/command = step_q == CLOSE ?/
