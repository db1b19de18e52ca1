s/onchip_req_o = go/onchip_req_o = !came_i \&\& go/
