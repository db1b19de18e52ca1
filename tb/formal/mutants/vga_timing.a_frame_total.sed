s/if (line_end_o) begin/if (!h_o) v_o <= v_next_o; if (line_end_o) begin/; s/v_o     <= v_next_o;//
