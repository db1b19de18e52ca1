// Initial words of memories: MIF, Intel HEX, and where they are found.

#include "sim/project/init_file.h"

#include <gmock/gmock.h>

#include <fstream>

#include "sim/project/memory_image.h"

namespace {

namespace fs = std::filesystem;
using sim::project::MemoryImage;
using testing::ElementsAre;
using testing::HasSubstr;

class InitFile : public testing::Test {
protected:
    InitFile() { fs::create_directories(folder); }
    ~InitFile() override { fs::remove_all(folder); }

    fs::path write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
        return folder / name;
    }

    // The words of a file, as numbers.
    std::vector<std::uint64_t> read(const std::string& text, unsigned width, std::size_t words) {
        const MemoryImage image = sim::project::read_memory_image(write("x", text), width, words);
        std::vector<std::uint64_t> result;
        for (std::size_t i = 0; i < words; ++i) {
            result.push_back(std::uint64_t{image.part(i, 1)} << 32 | image.part(i, 0));
        }
        return result;
    }

    // What follows "FILE" in the message about a broken file.
    std::string refusal(const std::string& text) {
        try {
            read(text, 8, 4);
        } catch (const std::runtime_error& error) {
            const std::string message = error.what();
            const std::string file = (folder / "x").string();
            EXPECT_EQ(message.substr(0, file.size()), file);
            return message.substr(file.size());
        }
        return "not refused";
    }

    const fs::path folder =
        fs::path(testing::TempDir()) /
        (std::string("init_file_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

const std::string HEAD = "WIDTH=8;\nDEPTH=16;\nADDRESS_RADIX=UNS;\nDATA_RADIX=HEX;\n";

TEST_F(InitFile, ReadsWordsListsAndRanges) {
    EXPECT_THAT(read(HEAD + "CONTENT BEGIN\n 0 : 1f;\n 1 : 2 3 04;\n [5..9] : a b;\nEND;\n", 8, 11),
                ElementsAre(0x1F, 2, 3, 4, 0, 0xA, 0xB, 0xA, 0xB, 0xA, 0));
}

TEST_F(InitFile, ReadsEachRadix) {
    const auto first = [&](const std::string& radix, const std::string& value) {
        return read(
            "WIDTH=8; DEPTH=4; DATA_RADIX=" + radix + "; CONTENT BEGIN 0:" + value + "; END;", 8,
            1)[0];
    };
    EXPECT_EQ(first("BIN", "10100101"), 0xA5);
    EXPECT_EQ(first("OCT", "245"), 0xA5);
    EXPECT_EQ(first("HEX", "A5"), 0xA5);
    EXPECT_EQ(first("UNS", "165"), 0xA5);
    EXPECT_EQ(first("DEC", "165"), 0xA5);
    EXPECT_EQ(first("DEC", "-91"), 0xA5);
}

TEST_F(InitFile, ReadsHexadecimalWhereNoRadixIsGiven) {
    EXPECT_THAT(read("DEPTH=32; WIDTH=8; CONTENT BEGIN 10 : 10; END;", 8, 17)[16], 0x10);
}

TEST_F(InitFile, SkipsComments) {
    EXPECT_THAT(read("-- a picture\r\n% by\n nobody; %WIDTH=8;DEPTH=4;\r\n"
                     "CONTENT\r\nBEGIN -- BEGIN\n0:1; % 1:5; % --2:6;\n3:4;\r\nEND;",
                     8, 4),
                ElementsAre(1, 0, 0, 4));
}

TEST_F(InitFile, DoesNotCareAboutCaseSpacesAndTheLastSemicolon) {
    EXPECT_THAT(read("\xEF\xBB\xBF"
                     "width = 8;depth=2;Data_Radix = hex;content begin\t1:fF;end",
                     8, 2),
                ElementsAre(0, 0xFF));
}

TEST_F(InitFile, ReadsWordsOfMoreThan32Bits) {
    EXPECT_THAT(
        read("WIDTH=40; DEPTH=2; DATA_RADIX=DEC; CONTENT BEGIN 0: 1099511627775 -2; END;", 40, 2),
        ElementsAre(0xFFFFFFFFFFu, 0xFFFFFFFFFEu));
}

TEST_F(InitFile, FitsAFileOfAnotherSizeToTheMemory) {
    EXPECT_THAT(read(HEAD + "CONTENT BEGIN 0: AB 1; 9: 7; END;", 4, 2), ElementsAre(0xB, 1));
    EXPECT_THAT(read(HEAD + "CONTENT BEGIN 0: AB 1; END;", 16, 3), ElementsAre(0xAB, 1, 0));
}

TEST_F(InitFile, ReportsWhereAMifIsBroken) {
    EXPECT_EQ(refusal("hello"),
              ":1: \"HELLO\", expected WIDTH, DEPTH, ADDRESS_RADIX, DATA_RADIX or CONTENT");
    EXPECT_EQ(refusal(""),
              ":1: the file ends, expected WIDTH, DEPTH, ADDRESS_RADIX, DATA_RADIX or CONTENT");
    EXPECT_EQ(refusal("WIDTH=8\nDEPTH=4;"), ":2: \"DEPTH\", expected \";\"");
    EXPECT_EQ(refusal("DATA_RADIX=ROM;"), ":1: \"ROM\", expected BIN, OCT, DEC, HEX or UNS");
    EXPECT_EQ(refusal(HEAD + "CONTENT BEGIN\n0 : 1FF;\nEND;"),
              ":6: \"1FF\", expected at most 8 bits");
    EXPECT_EQ(refusal(HEAD + "CONTENT BEGIN\n0 : 1G;\nEND;"),
              ":6: \"1G\", expected a value in base 16");
    EXPECT_EQ(refusal(HEAD + "CONTENT BEGIN\n0 : ;\nEND;"), ":6: \";\", expected a value");
    EXPECT_EQ(refusal(HEAD + "CONTENT BEGIN\n16 : 0;\nEND;"),
              ":6: \";\", expected addresses 16 to 16 in order and below DEPTH=16");
    EXPECT_EQ(refusal(HEAD + "CONTENT BEGIN\n[3..2] : 0;\nEND;"),
              ":6: \";\", expected addresses 3 to 2 in order and below DEPTH=16");
    EXPECT_EQ(refusal(HEAD + "CONTENT BEGIN\n0 : 1;\n"), ":7: the file ends, expected an address");
    EXPECT_EQ(refusal(HEAD + "CONTENT BEGIN\n0 : 1\n"), ":7: the file ends, expected a value");
    EXPECT_EQ(refusal("CONTENT BEGIN 0:1;"),
              ":1: \"0\", expected WIDTH and DEPTH before the content");
    EXPECT_EQ(refusal("% no end"), ":1: \"%\", expected another % at the comment's end");
}

TEST_F(InitFile, ReadsTheAddressesOfIntelHexAsThoseOfWords) {
    EXPECT_THAT(read(":020000000102FB\n:02000100AABB98\n:00000001FF\n", 16, 3),
                ElementsAre(0x0102, 0xAABB, 0));
}

TEST_F(InitFile, ContinuesARecordInTheWordsThatFollow) {
    EXPECT_THAT(read(":0400000001020304F2\n:00000001FF\n", 16, 3), ElementsAre(0x0102, 0x0304, 0));
    EXPECT_THAT(read(":0400000001020304F2\r\n", 8, 5), ElementsAre(1, 2, 3, 4, 0));
    EXPECT_THAT(read(":0400000001020304F2", 12, 3), ElementsAre(0x102, 0x304, 0));
}

TEST_F(InitFile, PadsAShortRecord) {
    EXPECT_THAT(read(":0100000005FA\n:0100010006F8\n:00000001FF\n", 40, 2), ElementsAre(5, 6));
}

TEST_F(InitFile, ReadsTheUpperPartOfAnAddress) {
    EXPECT_EQ(read(":020000021000EC\n:0100010007F7\n:00000001FF\n", 8, 0x10002)[0x10001], 7u);
    EXPECT_EQ(read(":020000040001F9\n:0100010007F7\n:00000001FF\n", 8, 0x10002)[0x10001], 7u);
}

TEST_F(InitFile, ReportsWhereIntelHexIsBroken) {
    EXPECT_THAT(refusal(":0100000005FA\n:0100010006F9\n"),
                HasSubstr(":2: the record has the checksum F9 instead of F8, expected :COUNT"));
    EXPECT_THAT(refusal(":0200000005FA"),
                HasSubstr(":1: the record has 1 bytes of data instead of 2"));
    EXPECT_THAT(refusal(":01000000x5FA"), HasSubstr(":1: the record column 10 is no byte"));
    EXPECT_THAT(refusal(":00"), HasSubstr(":1: the record is too short"));
    EXPECT_THAT(refusal(":00000001FF\n;"), "not refused");
    EXPECT_THAT(refusal(":0100000005FA\n0 1"),
                HasSubstr(":2: the record does not begin with a colon"));
    EXPECT_THAT(refusal(":0000000AF6"), HasSubstr(":1: the record is of kind 0A"));
    EXPECT_THAT(refusal(":0100000401FA"), HasSubstr(":1: the record is of kind 02 or 04 without"));
}

TEST_F(InitFile, ReportsThatAFileCannotBeRead) {
    EXPECT_THROW(sim::project::read_memory_image(folder / "none", 8, 4), std::runtime_error);
    EXPECT_THROW(sim::project::read_memory_image(folder, 8, 4), std::runtime_error);
}

TEST_F(InitFile, IsSoughtFromTheProjectsFolderFirst) {
    const auto there = write("project/a/x.mif", "");
    const auto above = write("x.mif", "");
    const auto source = write("rtl/y.mif", "");
    write("project/b/y.mif", "");
    const sim::project::InitFolders folders{folder / "project", {folder / "rtl"}};
    EXPECT_EQ(sim::project::find_init_file("a/x.mif", folders), there);
    EXPECT_EQ(sim::project::find_init_file("../x.mif", folders), above);
    EXPECT_EQ(sim::project::find_init_file("./y.mif", folders), source);
    EXPECT_EQ(sim::project::find_init_file(".\\a\\x.mif", folders), there);
}

TEST_F(InitFile, IsFoundByItsNameBelowTheProjectsFolder) {
    const auto there = write("deep/er/font.mif", "");
    write("deep/a/Font.MIF", "");
    const sim::project::InitFolders folders{folder, {}};
    EXPECT_EQ(sim::project::find_init_file("C:\\work\\font.mif", folders), there);
    EXPECT_EQ(sim::project::find_init_file("../other/FONT.mif", folders),
              folder / "deep/a/Font.MIF");
    EXPECT_FALSE(sim::project::find_init_file("no.mif", folders));
}

}  // namespace
