s/write_gray_q <= gray(write_q + ONE)/write_gray_q <= write_q + ONE/
