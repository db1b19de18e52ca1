s/count_o <= left(pop_i) + ONE/count_o <= count_o + ONE/
