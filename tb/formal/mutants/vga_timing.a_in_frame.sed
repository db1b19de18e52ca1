s/v_o      <= V_SHOWN;  /v_o      <= 10'd600;/
