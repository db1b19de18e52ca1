s/ || sent_o//
