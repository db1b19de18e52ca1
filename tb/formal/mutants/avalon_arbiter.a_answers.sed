s/owners_q\[end_q\] <= turn/owners_q[end_q] <= turn_q/
