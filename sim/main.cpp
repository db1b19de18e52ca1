// main.cpp - de1sim with the project's own firmware.
#include "app/app.h"
#include "sim/program.h"

int main(int argc, char** argv) { return sim::program(argc, argv, app::run); }
