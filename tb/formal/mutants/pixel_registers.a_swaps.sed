s/front_o <= back_q/front_o <= front_o/
