s/count_o <= push == pop ? count_o : push ?/count_o <= push_i == pop ? count_o : push_i ?/
