# sleeps
s/ || irq_o != (ri || wi)//
