# sleeps
s/ || irq != irq_o//
