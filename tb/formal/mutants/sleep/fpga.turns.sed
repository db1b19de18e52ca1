# clocks.memory_group sleeps
s/ || turns_awake),/),/
