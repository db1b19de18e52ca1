// app.h - the program: keypad in, picture and sound out, 60 times per second.
//
//   keypad -> step -> draw -> back picture -> swap -+-> wait for the frame's end, feeding the sound
//      ^--------------------------------------------'
#pragma once

#include "hal/cpu.h"
#include "hal/mmio.h"

namespace app {

// Runs for ever.  Returns only if the system ID is not the one that it was built for, after a
// message on the console.  SW9-SW0, read once at the start, choose the seed of the shapes.
void run(hal::Mmio& io, hal::Cpu& cpu);

}  // namespace app
