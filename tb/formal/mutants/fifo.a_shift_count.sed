s/count_o <= left + ONE/count_o <= count_o + ONE/
