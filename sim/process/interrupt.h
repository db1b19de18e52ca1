// interrupt.h - somebody asks this process to end: SIGINT, SIGTERM or SIGHUP.
#pragma once

namespace sim {

// From now on these signals are noted and do nothing else.  SIGHUP stays ignored under nohup.
void note_interrupts();
// Whether one of them has come since.
bool interrupted();

}  // namespace sim
