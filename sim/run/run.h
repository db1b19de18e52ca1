// run.h - one simulation from its description to its files; once per process, as SystemC wants it.
#pragma once

#include "sim/cpu/firmware.h"
#include "sim/report/exit_code.h"
#include "sim/run/run_client.h"

namespace sim {

// Plays the scenario, or runs the program until it ends, and writes frames/, audio.wav,
// console.txt, report.json and junit.xml into the output folder.  Errors go to stderr, a line each;
// progress too, unless quiet.  A run that an internal error ends leaves its report as well.
// `make_client`: called where the description has a live_socket.
ExitCode run(const RunDescription& description, const Firmware& firmware,
             const RunClientMaker& make_client);

}  // namespace sim
