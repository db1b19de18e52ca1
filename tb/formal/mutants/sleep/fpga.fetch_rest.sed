s/if (fetch_rest_i < rest_o) rest_o = fetch_rest_i;//
