// trace_file_test.cpp - a truncated waveform file never appears
#include "sim/files/trace_file.h"

#include <csignal>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tb/support/temp_folder.h"

namespace {

// An FST block: a type, eight bytes of length (these included), the content.
std::string block(unsigned char type, std::size_t bytes) {
    std::string text(1, static_cast<char>(type));
    for (int shift = 56; shift >= 0; shift -= 8)
        text += static_cast<char>((bytes + 8) >> shift & 0xff);
    return text + std::string(bytes, '\x55');
}

const std::string HEADER = block(0, 321), CHANGES = block(8, 5000), GEOMETRY = block(3, 100),
                  HIERARCHY = block(4, 200), UNFINISHED = block(255, 50);
const std::string WHOLE = HEADER + CHANGES + GEOMETRY + HIERARCHY;

class TraceFile : public testing::Test {
protected:
    bool is_whole(const std::string& bytes) {
        std::ofstream{folder / "x.fst", std::ios::binary} << bytes;
        return sim::is_whole_fst(folder / "x.fst");
    }

    TempFolder folder;
};

TEST_F(TraceFile, IsWholeWithAllItsBlocks) { EXPECT_TRUE(is_whole(WHOLE)); }

TEST_F(TraceFile, IsNotWholeWhenItIsCutOffAnywhere) {
    for (std::size_t size = 0; size < WHOLE.size(); size += 7)
        EXPECT_FALSE(is_whole(WHOLE.substr(0, size))) << size;
}

TEST_F(TraceFile, IsNotWholeWithoutOneOfItsParts) {
    EXPECT_FALSE(is_whole(CHANGES + GEOMETRY + HIERARCHY));
    EXPECT_FALSE(is_whole(HEADER + CHANGES + HIERARCHY));
    EXPECT_FALSE(is_whole(HEADER + CHANGES + GEOMETRY));
}

TEST_F(TraceFile, IsNotWholeWithABlockThatWasNeverFinished) {
    EXPECT_FALSE(is_whole(HEADER + UNFINISHED + GEOMETRY + HIERARCHY));
}

TEST_F(TraceFile, AppearsWhenItIsWhole) {
    sim::TraceFile trace{folder / "x.fst"};
    std::ofstream{trace.part(), std::ios::binary} << WHOLE;
    EXPECT_FALSE(std::filesystem::exists(folder / "x.fst"));
    trace.commit();
    EXPECT_EQ(std::filesystem::file_size(folder / "x.fst"), WHOLE.size());
}

TEST_F(TraceFile, IsAnErrorWhenItWasCutOff) {
    {
        sim::TraceFile trace{folder / "x.fst"};
        std::ofstream{trace.part(), std::ios::binary} << WHOLE.substr(0, 4000);
        EXPECT_THROW(trace.commit(), sim::IoError);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(TraceFile, EndsTheProgramInOneLineOnAFullDisk) {
    const auto meets_a_full_disk = [this] {
        sim::TraceFile trace{folder / "x.fst"};
        std::raise(SIGBUS);
    };
    EXPECT_EXIT(meets_a_full_disk(), testing::ExitedWithCode(2),
                "^de1sim: .*x.fst: cannot write: it was cut off .is the disk full..\n$");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
