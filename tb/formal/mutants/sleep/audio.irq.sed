s/ || irq != irq_o//
