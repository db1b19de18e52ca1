// terminal_text.h - what a simulated program prints, made safe for the terminal of a person.
//
// As a serial terminal shows it: text in UTF-8, tabs, backspaces, carriage returns, and of the
// escape sequences those that move the cursor, erase, or colour.  All else, which could set modes
// that stay or make the terminal answer, is shown as text: \xNN.
//
// Not handled: sequences and characters that end in a later run of the program.
#pragma once

#include <string>
#include <string_view>

namespace sim {

class TerminalText {
public:
    // The text of these bytes.  A character or sequence that is not complete is kept for the next.
    std::string show(std::string_view bytes);
    // What is still kept, and a sequence that takes colours back if there were any.
    std::string end();

private:
    std::string kept_;
    bool coloured_ = false;
};

}  // namespace sim
