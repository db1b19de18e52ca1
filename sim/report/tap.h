// tap.h - a program's own tests: what it printed in the Test Anything Protocol, version 13
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace sim {

struct Check {
    std::string name;
    bool met = false;
    std::string detail;  // the text after the name's ": "
};

// Reads what a program prints, character by character, from the line "TAP version 13" on; there are
// no checks without that line.  "\r\n" ends a line, too.  Tests of the plan "1..N" that do not
// appear, and "Bail out!", are checks that are not met. "# TODO" and "# SKIP" count as met, as TAP
// specifies.
//
// Its memory is limited: it reads the first LINE characters of a line and keeps CHECKS checks.  If
// there are more, an additional check that is not met says so.
class TapReader {
public:
    static constexpr std::size_t LINE = 4096, CHECKS = 100'000;

    void print(char character);
    // In all that was printed so far, the line that is not ended included.
    std::vector<Check> checks() const;

private:
    enum class State { BEFORE, WITHIN, BEHIND };  // the first line; a bail out

    void end_line();

    State state_ = State::BEFORE;
    std::string line_;
    std::vector<Check> checks_;
    std::size_t made_ = 0;
    std::optional<std::size_t> planned_;
};

}  // namespace sim
