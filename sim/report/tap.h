// tap.h - a program's own tests: what it printed in the Test Anything Protocol, version 13
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim {

struct Check {
    std::string name;
    bool met = false;
    std::string detail;  // what stands behind the name's ": "
};

// The checks in `console`, from the line "TAP version 13" on; none without that line.  "\r\n" ends
// a line, too.  What the plan "1..N" promises and the text does not hold, and "Bail out!", are
// checks that are not met.  "# TODO" and "# SKIP" count as met, as TAP wants it.
std::vector<Check> tap_checks(std::string_view console);

}  // namespace sim
