s/memory\[read_q\]/memory[0]/
