// cpu.h - what the firmware asks of the processor itself.
#pragma once

namespace hal {

class Cpu {
public:
    // Nothing to do: sleeps for a while, at most 100 us.
    virtual void idle() = 0;

protected:
    ~Cpu() = default;
};

}  // namespace hal
