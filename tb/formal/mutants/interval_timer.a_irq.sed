s/irq_o   = to_q/irq_o   = run_q/
