s/row ? row_q + PITCH/row ? row_q + PITCH + 28'd1/
