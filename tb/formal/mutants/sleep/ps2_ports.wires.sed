# sleeps
s/ || wires_q != meta_q$//
