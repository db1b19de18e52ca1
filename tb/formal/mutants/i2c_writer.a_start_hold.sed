s/if (ack_cell \&\& sdat) nack_o <= 1'b1;/begin if (ack_cell \&\& sdat) nack_o <= 1'b1; if (cell_q == START) sclk_o <= 1'b0; end/
