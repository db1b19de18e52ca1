// self_test.h - the board checked by its own processor, with a person, or a scenario, in front.
#pragma once

#include "hal/cpu.h"
#include "hal/mmio.h"

namespace selftest {

// Is told the result of each check.  If the check is met, `detail` is the same on every board and
// in the simulation, so that two lists can be compared.
class Listener {
public:
    virtual void decided(const char* name, bool met, const char* detail) = 0;

protected:
    ~Listener() = default;
};

// Makes all checks and returns how many are not met; some 20, a few seconds without the person's
// part.  Prints them as TAP 13 (testanything.org); lines with "#" tell the person what to do, and
// each waits 60 s for that.  Registers are left as after reset; both pictures are overwritten.
// A wrong system ID ends it at once ("Bail out!"), because the other results would then be
// meaningless.
unsigned run(hal::Mmio& io, hal::Cpu& cpu, Listener* listener = nullptr);

}  // namespace selftest
