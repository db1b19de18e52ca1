s/if (!rectangle(last_q))/if (1'b1)/
