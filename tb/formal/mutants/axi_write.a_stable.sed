s/if (bvalid_o \&\& bready_i) begin/if (bvalid_o) begin/
