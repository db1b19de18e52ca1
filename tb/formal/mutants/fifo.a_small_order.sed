s/memory\[read_q\[DEPTH_LOG2-1:0\]\]/memory[0]/
