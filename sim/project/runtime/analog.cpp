#include "sim/project/runtime/analog.h"

#include "sim/pins/pins.h"

namespace {

const sim::PinListener* analog_board = nullptr;

}  // namespace

extern "C" void de1sim_set_analog(const sim::PinListener* board) { analog_board = board; }

extern "C" int de1sim_analog_mv(int input) {
    return analog_board && input >= 0 && input < 8
               ? analog_board->analog_mv(static_cast<unsigned>(input))
               : 0;
}
