s/v_next_o   = v_o == V_TOTAL - 10'd1 ?/v_next_o   = v_o == V_TOTAL ?/
