s/if (timer1_rest_i < rest_o) rest_o = timer1_rest_i;//
