# sleeps
s/ || write_decode_awake$//
