s/ || turns_awake),/),/
