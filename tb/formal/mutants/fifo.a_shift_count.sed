s/count_o <= push ? left + ONE : left/count_o <= push ? count_o + ONE : left/
