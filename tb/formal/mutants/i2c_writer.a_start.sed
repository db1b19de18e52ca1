s/if (cell_q == STOP) sdat_oe_o <= 1'b1;/if (cell_q == STOP || cell_q == START) sdat_oe_o <= 1'b1;/
