# sleeps
s/awake_o = shown_q || /awake_o = /
