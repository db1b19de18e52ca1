// read_scenario.cpp - prints for each file whether the reader accepts it: "ok", or the error
#include <iostream>

#include "sim/scenario/scenario.h"

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        try {
            sim::load_scenario(argv[i]);
            std::cout << "ok\n";
        } catch (const sim::ScenarioError& error) {
            std::cout << error.what() << "\n";
        }
    }
}
