s/written ^ written >> 1/written/
