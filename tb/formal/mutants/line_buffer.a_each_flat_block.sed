s/reg \[19:0\] even_q/reg [18:0] even_q/
