s/row_next_o = v_next/row_next_o = v_o/
