# sleeps
s/ || room != room_o;/;/
