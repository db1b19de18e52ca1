s/if (we_was_q \&\& werror_i)/if (we_o \&\& werror_i)/
