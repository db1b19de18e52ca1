s/take_o         = take \&\& !screen/take_o         = take/
