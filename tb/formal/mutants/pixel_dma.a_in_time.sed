s/(waiting_q || asked_q == got_q)/waiting_q/
