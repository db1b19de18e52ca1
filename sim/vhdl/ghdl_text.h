// ghdl_text.h - one module of the Verilog that GHDL writes, whose lines are of a few kinds
//
//     wire [3:0] n6_o;                      declarations
//     assign n6_o = oe ? d : n4_o;          one operation
//     always @(posedge clk)
//       n9_q <= n6_o;                       one assignment; in a case "2'b10: n9_q <= 1;"
//     pad u (
//       .io(u_io));                         a line for each connection
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sim::project {

struct GhdlAssignment {
    std::size_t begin;                // of the target in the line
    std::string target, sign, value;  // sign: " = " or " <= "
    std::size_t end;                  // of the value in the line
};
std::optional<GhdlAssignment> assignment_in(const std::string& line);

// What an expression passes on bit by bit: "c ? a : b", "{a, b}", "a", "a[3:0]"; not "a & b".
struct Passed {
    std::string condition;
    std::vector<std::string> atoms;
};
std::optional<Passed> passed(const std::string& value);

bool is_literal(const std::string& atom);      // 4'b01ZZ
std::string name_of(const std::string& atom);  // n of n[3:0]
std::string trimmed(const std::string& text);  // without the blanks at its ends

struct Declarations {
    explicit Declarations(const std::vector<std::string>& lines);
    // The bits of an atom, or 0 if they are not known.
    std::size_t width_of(const std::string& atom) const;

    std::map<std::string, std::size_t> widths;
    std::set<std::string> inouts, driven;  // ports; driven: outputs, too
};

}  // namespace sim::project
