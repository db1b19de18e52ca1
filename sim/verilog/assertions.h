// assertions.h - concurrent assertions, which Quartus reads and ignores
//
//   property p; @(posedge clk) a |=> b; endproperty      sequence s; a ##1 b; endsequence
//   check: assert property (p) else $error("b is late");  assume, cover, restrict alike
//
// Source: Quartus Prime Help, "Section 16 - Assertions".
#pragma once

#include <string>
#include <string_view>

namespace sim::project {

struct WithoutAssertions {
    std::string text;
    unsigned line = 0;  // of the first that was left out; 0: there is none
};

// The same SystemVerilog with blanks in their place; a statement of a process leaves its semicolon.
WithoutAssertions without_assertions(std::string_view text);

}  // namespace sim::project
