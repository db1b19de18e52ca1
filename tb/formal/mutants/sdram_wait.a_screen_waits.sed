s/screen = screen_req_i \&\& !begun_q/screen = screen_req_i \&\& !req_i/
