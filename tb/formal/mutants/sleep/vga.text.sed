# rests
s/{9'd0, !text_q}/10'd1/
