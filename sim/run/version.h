// version.h - which de1sim this is
#pragma once

namespace sim {

// "de1sim 1.2.3", then in brackets the commit and the options that it was built with.
extern const char* const VERSION;

}  // namespace sim
