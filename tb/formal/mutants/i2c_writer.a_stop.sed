s/if (ack_cell \&\& sdat) nack_o <= 1'b1;/begin if (ack_cell \&\& sdat) nack_o <= 1'b1; sdat_oe_o <= 1'b0; end/
