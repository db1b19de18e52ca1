// memory.h - the translation table, and MMU and caches on.
#pragma once

// Flat: every virtual address is its physical one.  DDR3 is cached and written back; the two
// pictures on the bridge are Normal memory that is not cached, so that stores to neighbouring words
// may go as one burst; all else is Device memory: each access as written, in order.  Nothing but
// DDR3 is executable.
extern "C" void memory_on();
