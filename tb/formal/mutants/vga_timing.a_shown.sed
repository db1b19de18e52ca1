/shown_o = /s/h_o < H_SHOWN/h_o <= H_SHOWN/
