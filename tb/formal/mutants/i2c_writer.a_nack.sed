s/busy_o    <= 1'b0;/begin busy_o <= 1'b0; nack_o <= 1'b0; end/
