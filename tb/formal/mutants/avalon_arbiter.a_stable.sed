s/if (valid_o) begin/if (taken) begin/
