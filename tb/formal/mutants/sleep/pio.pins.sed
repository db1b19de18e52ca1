s/ || pins_awake || / || /
