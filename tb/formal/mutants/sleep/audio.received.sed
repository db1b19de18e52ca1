s/valid_o || adcdat_awake/adcdat_awake/
