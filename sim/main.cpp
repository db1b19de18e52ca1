// main.cpp - de1sim with the project's own firmware.
#include <cstdlib>

#include "app/app.h"
#include "sim/run/cli.h"

#include <systemc>

int sc_main(int argc, char** argv) { return sim::main(argc, argv, app::run); }

// libsystemc's own main would print its banner.
int main(int argc, char** argv) {
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
    return sc_core::sc_elab_and_sim(argc, argv);
}
