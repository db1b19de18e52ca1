# sleeps
s/|| reader_awake || re ||/|| re ||/
