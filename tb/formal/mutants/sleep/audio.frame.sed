s/ || frame//
