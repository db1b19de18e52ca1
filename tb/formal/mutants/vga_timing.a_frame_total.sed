s/if (line_end_o) begin/if (!h_o) v_o <= v_next; if (line_end_o) begin/; s/v_o     <= v_next;//
