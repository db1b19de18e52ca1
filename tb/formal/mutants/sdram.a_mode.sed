s/MODE     = 13'h021/MODE     = 13'h031/
