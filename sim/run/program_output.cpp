// program_output.cpp - see program_output.h
#include "sim/run/program_output.h"

#include <unistd.h>

#include <utility>

#include "sim/text/messages.h"

namespace sim {

namespace {

constexpr std::size_t LONG = 4096;  // for a line

}  // namespace

ProgramOutput::ProgramOutput(bool at_once)
    : at_once_{at_once}, terminal_{isatty(STDOUT_FILENO) == 1} {}

void ProgramOutput::print(char character) {
    line_ += character;
    if (at_once_ || character == '\n' || line_.size() >= LONG) flush();
}

void ProgramOutput::flush() {
    if (line_.empty()) return;
    const std::string bytes = std::exchange(line_, {});
    print_output(terminal_ ? text_.show(bytes) : bytes);
}

void ProgramOutput::end() {
    flush();
    print_output(text_.end());
}

}  // namespace sim
