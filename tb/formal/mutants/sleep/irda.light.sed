# sleeps
s/ || !rxd || busy_q/ || busy_q/
