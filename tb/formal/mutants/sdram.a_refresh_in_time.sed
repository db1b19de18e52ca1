s/(opened_q || !refresh_q)/(open_q != 0 || !refresh_q)/
