# sleeps
s/awake_o = start || /awake_o = /
