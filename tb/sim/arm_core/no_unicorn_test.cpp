// In place of the comparison with Unicorn, where it or dynarmic is not installed.
#include <gmock/gmock.h>

TEST(AgainstUnicorn, TheProcessorDoesTheSame) {
    GTEST_SKIP() << "needs libdynarmic-dev and libunicorn-dev";
}
