s/ || sent_awake//
