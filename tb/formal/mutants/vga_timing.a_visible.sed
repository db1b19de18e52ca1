/visible_o  = /s/v_o < V_SHOWN/v_o <= V_SHOWN/
