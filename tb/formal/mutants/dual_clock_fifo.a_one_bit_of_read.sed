s/read_gray_q <= gray(read_q + ONE)/read_gray_q <= read_q + ONE/
