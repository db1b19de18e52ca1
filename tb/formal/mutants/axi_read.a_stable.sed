s/if (rvalid_o \&\& rready_i) begin/if (rvalid_o) begin/
