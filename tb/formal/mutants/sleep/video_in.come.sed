s/ || come_awake//
