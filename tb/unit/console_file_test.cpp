// console_file_test.cpp - console.txt is complete up to a limit; longer output keeps its beginning
// and end
#include <gmock/gmock.h>

#include "sim/files/console_file.h"
#include "tb/support/temp_folder.h"

namespace {

using sim::ConsoleFile;

class ConsoleOnDisk : public ::testing::Test {
protected:
    // Bytes without long repetitions.
    static std::string bytes(std::size_t count) {
        std::string text;
        for (std::size_t i = 0; text.size() < count; ++i) text += std::to_string(i) + "\n";
        return text.substr(0, count);
    }
    std::string file_of(const std::string& printed) const {
        ConsoleFile file{folder / "console.txt"};
        for (const char c : printed) file.print(c);
        file.commit();
        return folder.get("console.txt");
    }
    const TempFolder folder;
};

TEST_F(ConsoleOnDisk, IsKeptWholeUpToItsLimit) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5000},
                                    ConsoleFile::FIRST, ConsoleFile::FIRST + ConsoleFile::LAST}) {
        const std::string printed = bytes(count);
        EXPECT_TRUE(file_of(printed) == printed) << count;
    }
}

TEST_F(ConsoleOnDisk, KeepsItsBeginningAndEndAndCountsTheRest) {
    for (const std::size_t more : {1, 4711, 3'000'000}) {
        const std::string printed = bytes(ConsoleFile::FIRST + ConsoleFile::LAST + more);
        EXPECT_TRUE(file_of(printed) ==
                    printed.substr(0, ConsoleFile::FIRST) + "\n[de1sim: " + std::to_string(more) +
                        " bytes left out]\n" + printed.substr(ConsoleFile::FIRST + more))
            << more;
    }
}

TEST_F(ConsoleOnDisk, IsNotThereWhereTheRunEndsBefore) {
    { ConsoleFile{folder / "console.txt"}.print('x'); }
    EXPECT_FALSE(std::filesystem::exists(folder / "console.txt"));
}

}  // namespace
