# sleeps
s/if (run) data_q <= /data_q <= /
