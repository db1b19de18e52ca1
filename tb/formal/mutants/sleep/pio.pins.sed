# sleeps
s/ || pins_awake || / || /
