s/FULL = 3 <</FULL = 1 <</
