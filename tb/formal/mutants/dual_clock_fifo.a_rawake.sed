s/write_coming || write_gray_q != write_seen/write_coming/
