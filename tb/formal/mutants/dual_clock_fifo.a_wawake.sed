s/read_coming || read_gray_q != read_seen/read_coming/
