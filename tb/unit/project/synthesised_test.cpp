// What Quartus reads of a file, and what is for simulators.
#include "sim/verilog/synthesised.h"

#include <gtest/gtest.h>

namespace {

using sim::project::as_synthesised;

TEST(Synthesised, IsTheWholeTextWithoutOrders) {
    for (const char* text :
         {"module m; // translate_off\nreg a; /* synthesis keep */ \"// pragma translate_off\" b;",
          "`ifdef A // no\n`else\nx /", "// synthesis translate_on\na", "\"", "`", "/*"})
        EXPECT_EQ(as_synthesised(text), text);
}

TEST(Synthesised, LeavesOutWhatStandsBetweenOffAndOn) {
    EXPECT_EQ(as_synthesised("a // synthesis translate_off\nb `endif /* c\n*/ \" d\n"
                             "  // synthesis translate_on\ne"),
              "a // synthesis translate_off\n             \n      \n"
              "  // synthesis translate_on\ne");
    EXPECT_EQ(as_synthesised("a /*pragma translate_off*/b"), "a /*pragma translate_off*/ ");
    EXPECT_EQ(as_synthesised("`define F(r) /``* synopsys x `\"r`\" *``/ q\nb"),
              "`define F(r)                            q\nb");
}

TEST(Synthesised, OrdersCountWhereTheirBranchIsTaken) {
    const std::string branch = "\n// pragma translate_off\n`endif\na";
    for (const char* head :
         {"`ifdef NO", "`ifndef YES", "`ifndef ALTERA_RESERVED_QIS", "`ifdef YES\n`else",
          "`ifdef NO\n`elsif NO\n`elsif YES\n`elsif ALTERA_RESERVED_QIS", "`undef YES\n`ifdef YES",
          "`ifdef NO\n`ifdef YES\n`endif\n`ifdef YES"})
        EXPECT_EQ(as_synthesised(head + branch, {"YES=1"}), head + branch);
    for (const char* head : {"`ifdef YES", "`define B 1\n`ifdef B", "`ifdef NO\n`else",
                             "`ifdef NO\n`elsif YES", "`ifdef NO\n`endif\n`ifdef YES"})
        EXPECT_NE(as_synthesised(head + branch, {"YES=1"}), head + branch) << head;
}

TEST(Synthesised, CommentsAreReadWhereTheyShallBe) {
    EXPECT_EQ(as_synthesised("// synthesis read_comments_as_HDL on\n// a\n/* b */c\n"
                             "// synthesis read_comments_as_HDL off\n// d"),
              "// synthesis read_comments_as_HDL on\n   a\n   b   c\n"
              "// synthesis read_comments_as_HDL off\n// d");
}

}  // namespace
