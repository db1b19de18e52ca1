// signal_receiver.h - what gets signals from outside: the Linux program on the board.
#pragma once

#include "sim/board/part.h"

namespace sim {

class SignalReceiver : public Part {
public:
    static constexpr int PROGRAM = 101;  // the number of the program's own process
    // By its number, to the process of a number.
    virtual void send(unsigned signal, int process) = 0;
};

}  // namespace sim
