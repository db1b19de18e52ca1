s/screen_re_i ? screen_index_i : rindex_i/re_i ? rindex_i : screen_index_i/
