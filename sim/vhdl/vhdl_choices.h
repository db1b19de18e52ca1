// vhdl_choices.h - choices that come from a generic: Quartus takes them, GHDL does not.
//
//   case count is                          if
//     when 0 to last - 1 => q <= a;        ((count) >= (0) and (count) <= (last - 1)) then q <= a;
//     when last | 9 => q <= b;             elsif ((count) = (last)) or ((count) = (9)) then ...
//     when others => q <= c;               else q <= c;
//   end case;                              end if;
//
//   with count select                      q <= a when ((count) = (last)) else b;
//     q <= a when last, b when others;
//
// Lines are kept.  Where there is no `others`, the last choice is all the rest: so, too, where all
// combinations of 0 and 1 are there, but none of the seven other values that std_logic has.
//
// Not handled: `case?` and `select?`, choices with other bits than 0 and 1, subtypes as choices:
// they stay refused.  Choices that overlap or leave values out, which Quartus refuses, are taken.
#pragma once

#include <optional>
#include <set>
#include <string>

namespace sim::project {

struct ChoicesAsConditions {
    std::string text;
    std::set<unsigned> lines;  // that are written otherwise
};

// All statements with a choice on one of `lines`, and on one of `incomplete` those with all
// combinations of bits.  Nothing: there is none that can be rewritten.
std::optional<ChoicesAsConditions> choices_as_conditions(const std::string& text,
                                                         const std::set<unsigned>& lines,
                                                         const std::set<unsigned>& incomplete = {});

}  // namespace sim::project
