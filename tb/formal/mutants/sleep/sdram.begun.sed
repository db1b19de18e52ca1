# sleeps
s/controller_awake || begun_q ||/controller_awake ||/
