s/if (line_end_o) v_o/if (h_o == 10'd0) v_o/
