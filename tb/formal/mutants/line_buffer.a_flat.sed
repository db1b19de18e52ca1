s/wdata_i == {last_q, last_q} \&\& (so_far_q .*/wdata_i == {last_q, last_q};/
