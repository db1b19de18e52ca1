s/ || scanned_q//
