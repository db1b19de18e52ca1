s/ || room != room_o;/;/
