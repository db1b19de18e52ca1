// firmware.h - firmware that is compiled for this machine and linked in, for the processor "native"
#pragma once

#include <functional>

#include "hal/cpu.h"
#include "hal/mmio.h"

namespace sim {

// Runs for ever, or until it returns, when it is done.
using Firmware = std::function<void(hal::Mmio&, hal::Cpu&)>;

}  // namespace sim
