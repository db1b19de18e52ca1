# sleeps
s/pixel_awake || text_awake/pixel_awake/
