// signal_receiver.h - what gets signals from outside: the Linux program on the board.
#pragma once

#include "sim/board/part.h"

namespace sim {

class SignalReceiver : public Part {
public:
    // By its number, to the process of a number; the program itself is 1.
    virtual void send(unsigned signal, int process) = 0;
};

}  // namespace sim
