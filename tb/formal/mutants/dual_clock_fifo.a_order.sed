s/if (read_q\[DEPTH_LOG2-1:0\] == m/if (write_q[DEPTH_LOG2-1:0] == m/
