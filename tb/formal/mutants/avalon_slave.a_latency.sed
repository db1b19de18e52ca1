s/line_q\[LATENCY-1\]/line_q[0]/
