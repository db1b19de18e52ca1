// Of several files that define one module, the one that is meant.
#include "sim/verilog/nearest.h"

#include <gtest/gtest.h>

namespace {

using sim::project::nearest;

TEST(Nearest, IsTheFileItselfBeforeOthersOfItsFolder) {
    EXPECT_EQ(nearest({"/p/a/a.v", "/p/a/top.v"}, "/p/a/top.v", "m"), 1u);
}

TEST(Nearest, IsInTheSameFolderBeforeThoseBelowAndAbove) {
    EXPECT_EQ(nearest({"/p/fill.v", "/p/a/sub/fill.v", "/p/a/fill.v"}, "/p/a/top.v", "m"), 2u);
}

TEST(Nearest, HasTheLongestPathInCommon) {
    EXPECT_EQ(nearest({"/p/fill.v", "/p/a/x/fill.v", "/p/b/x/fill.v"}, "/p/b/y/top.v", "m"), 2u);
    EXPECT_EQ(nearest({"/p/ab/fill.v", "/p/a/c/fill.v"}, "/p/a/b/top.v", "m"), 1u);
}

TEST(Nearest, OfSeveralIsTheFirst) {
    EXPECT_EQ(nearest({"/p/b/fill.v", "/p/c/fill.v", "/p/a/fill.v"}, "/p/top.v", "m"), 0u);
}

TEST(Nearest, OfOneFolderIsTheOneWithTheModulesName) {
    EXPECT_EQ(nearest({"/p/a_copy.v", "/p/Fill.sv", "/p/z.v"}, "/p/top.v", "fill"), 1u);
    EXPECT_EQ(nearest({"/p/a/x.v", "/p/b/fill.v"}, "/p/a/top.v", "fill"), 0u);
}

}  // namespace
