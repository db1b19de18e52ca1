s/if (pipe_q\[1\]) low_q/if (pipe_q[0]) low_q/
