s/row ? row_q + PITCH/row ? row_q + PITCH + 26'd1/
