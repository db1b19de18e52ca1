// main.cpp - de1sim with the project's own firmware.
#include "app/app.h"
#include "sim/run/program.h"

int main(int argc, char** argv) { return sim::program(argc, argv, app::run); }
