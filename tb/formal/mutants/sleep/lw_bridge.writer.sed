# sleeps
s/writer_awake || we ||/we ||/
