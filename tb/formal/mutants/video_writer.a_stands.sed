s/onchip_req_o = !none/onchip_req_o = !came_i \&\& !none/
