# framed by a reset
s/cell_o    <= 1'b0;/cell_o    <= cell_o;/
