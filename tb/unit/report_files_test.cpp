// report_files_test.cpp - files appear whole or not at all; pictures and sums of them
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <random>
#include <thread>

#include "sim/files/frame_writer.h"
#include "sim/files/sha256.h"
#include "sim/files/whole_file.h"
#include "sim/text/printable.h"
#include "tb/support/temp_folder.h"

namespace {

using namespace sim;
namespace fs = std::filesystem;

template <class Call>
std::string io_error(const Call& call) {
    try {
        call();
    } catch (const IoError& error) {
        return error.what();
    }
    return "no error";
}

// Makes the next write of NAME fail with a full disk: its temporary file is /dev/full.
void fill_disk_for(const fs::path& name) {
    fs::create_symlink("/dev/full", name.string() + ".part");
}

Image grey(unsigned number) {
    return Image{64, 48, std::vector<std::uint8_t>(64 * 48 * 3, static_cast<std::uint8_t>(number))};
}

TEST(WholeFile, IsThereOnlyAfterTheCommit) {
    const TempFolder folder;
    WholeFile file(folder / "a.txt");
    file.write("hello", 5);
    EXPECT_FALSE(fs::exists(folder / "a.txt"));
    file.commit();
    EXPECT_EQ(folder.get("a.txt"), "hello");
    EXPECT_EQ(folder.count(), 1u);
}

TEST(WholeFile, LeavesTheOldFileWhenItIsGivenUp) {
    const TempFolder folder;
    folder.put("a.txt", "old");
    { WholeFile(folder / "a.txt").write("new", 3); }
    EXPECT_EQ(folder.get("a.txt"), "old");
    EXPECT_EQ(folder.count(), 1u);
}

TEST(WholeFile, ReplacesTheOldFile) {
    const TempFolder folder;
    folder.put("a.txt", "old and long");
    write_whole_file(folder / "a.txt", "new");
    EXPECT_EQ(folder.get("a.txt"), "new");
}

TEST(WholeFile, ReportsThatTheDiskIsFullAndLeavesNothing) {
    const TempFolder folder;
    fill_disk_for(folder / "a.txt");
    EXPECT_EQ(io_error([&] { write_whole_file(folder / "a.txt", "hello"); }),
              (folder / "a.txt").string() + ": cannot write: No space left on device");
    EXPECT_EQ(folder.count(), 0u);
}

TEST(WholeFile, ReportsWhyItCanNotBeMade) {
    const TempFolder folder;
    folder.put("file", "");
    fs::create_directory(folder / "folder");
    EXPECT_EQ(io_error([&] { write_whole_file(folder / "no/a.txt", "a"); }),
              (folder / "no/a.txt").string() + ": cannot create: No such file or directory");
    EXPECT_EQ(io_error([&] { write_whole_file(folder / "file/a.txt", "a"); }),
              (folder / "file/a.txt").string() + ": cannot create: Not a directory");
    EXPECT_EQ(io_error([&] { write_whole_file(folder / "folder", "a"); }),
              (folder / "folder").string() + ": cannot create: Is a directory");
    EXPECT_EQ(folder.count(), 2u);
}

TEST(WholeFile, MakesFoldersWithTheirParents) {
    const TempFolder folder;
    make_folder(folder / "a/b");
    make_folder(folder / "a/b");
    EXPECT_TRUE(fs::is_directory(folder / "a/b"));
    folder.put("file", "");
    EXPECT_EQ(io_error([&] { make_folder(folder / "file/b"); }),
              (folder / "file/b").string() + ": cannot create the folder: Not a directory");
}

TEST(FrameWriter, WritesEachPictureUnderItsNumber) {
    const TempFolder folder;
    FrameWriter writer(folder.path());
    for (unsigned i = 1; i <= 30; ++i) writer.push(i, grey(i));
    writer.push(1234567, grey(77));
    writer.close();
    for (unsigned i = 1; i <= 30; ++i) {
        const std::string name = std::string("frames/frame_0000") + (i < 10 ? "0" : "");
        EXPECT_EQ(read_png(folder / (name + std::to_string(i) + ".png")), grey(i));
    }
    EXPECT_EQ(read_png(folder / "frames/frame_1234567.png"), grey(77));
    EXPECT_EQ(folder.count(), 1 + 31u);
}

TEST(FrameWriter, WritesWhatWasPushedEvenIfNobodyClosesIt) {
    const TempFolder folder;
    { FrameWriter(folder.path()).push(1, grey(1)); }
    EXPECT_EQ(read_png(folder / "frames/frame_000001.png"), grey(1));
}

TEST(FrameWriter, ReportsAFullDiskWhenItIsClosed) {
    const TempFolder folder;
    FrameWriter writer(folder.path());
    fill_disk_for(folder / "frames/frame_000001.png");
    const std::string full =
        (folder / "frames/frame_000001.png").string() + ": cannot write: No space left on device";
    writer.push(1, grey(1));
    EXPECT_EQ(io_error([&] { writer.close(); }), full);
    EXPECT_EQ(folder.count(), 1u);
}

TEST(FrameWriter, ReportsAFullDiskToAWaitingProducer) {
    const TempFolder folder;
    FrameWriter writer(folder.path());
    fill_disk_for(folder / "frames/frame_000001.png");
    const auto push_many = [&] {
        for (unsigned i = 1; i < 100000; ++i) writer.push(i, grey(i));
    };
    EXPECT_THAT(io_error(push_many), testing::HasSubstr("No space left on device"));
    EXPECT_THAT(io_error([&] { writer.push(1, grey(1)); }), testing::HasSubstr("No space left"));
    EXPECT_EQ(folder.count(), 1u);
}

TEST(FrameWriter, MakesTheProducerWaitWhileEightPicturesAreQueued) {
    const TempFolder folder;
    FrameWriter writer(folder.path());
    // The first picture goes into a pipe, which blocks the worker when it holds 64 KiB.
    const std::string pipe = (folder / "frames/frame_000000.png.part").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDWR | O_NONBLOCK);
    Image noise{320, 240, {}};
    std::mt19937 random(1);
    for (int i = 0; i < 3 * 320 * 240; ++i)
        noise.rgb.push_back(static_cast<std::uint8_t>(random()));

    std::atomic<unsigned> pushed{0};
    std::thread producer([&] {
        for (; pushed < 20; ++pushed) writer.push(pushed, pushed == 0 ? noise : grey(pushed));
    });
    for (int i = 0; i < 1000 && pushed < 8; ++i) usleep(1000);
    usleep(50'000);  // time enough for a ninth
    EXPECT_EQ(pushed, 8u);
    std::vector<char> sink(65536);
    while (pushed < 20)
        if (read(reader, sink.data(), sink.size()) <= 0) usleep(1000);
    close(reader);
    producer.join();
    writer.close();
    EXPECT_EQ(folder.count(), 1 + 20u);
}

TEST(FrameWriter, ReportsAtOnceThatItsFolderCanNotBeMade) {
    const TempFolder folder;
    folder.put("frames", "a file");
    EXPECT_THAT(io_error([&] { FrameWriter writer(folder.path()); }),
                testing::HasSubstr("/frames: cannot create the folder: "));
}

TEST(FrameWriter, RefusesPicturesAfterClose) {
    const TempFolder folder;
    FrameWriter writer(folder.path());
    writer.close();
    EXPECT_THROW(writer.push(1, grey(1)), std::logic_error);
}

TEST(Sha256, GivesTheDigestsOfTheStandard) {  // FIPS 180-4, examples of NIST
    EXPECT_EQ(sha256_hex("", 0),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_hex("abc", 3),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_hex(std::vector<std::uint8_t>(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, AgreesWithSha256sum) {
    const TempFolder folder;
    const auto png = encode_png(grey(5));
    write_whole_file(folder / "a.png", png.data(), png.size());
    EXPECT_EQ(output_of("sha256sum < " + (folder / "a.png").string()), sha256_hex(png) + "  -\n");
}

TEST(Printable, LeavesTextAloneAndEscapesWhatControlsATerminal) {
    EXPECT_EQ(printable("Gr\xC3\xBC\xC3\x9F"
                        "e \xE2\x82\xAC \xF0\x9F\x99\x82"),
              "Gr\xC3\xBC\xC3\x9F"
              "e \xE2\x82\xAC \xF0\x9F\x99\x82");
    EXPECT_EQ(printable("a\x1B[2J\r\n\t\x7F"), "a\\x1b[2J\\x0d\\x0a\\x09\\x7f");
    EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
    EXPECT_EQ(printable("\xC2\x9B"), "\\xc2\\x9b");           // C1: CSI
    EXPECT_EQ(printable("\xE2\x80\xAE"), "\\xe2\\x80\\xae");  // right-to-left override
    EXPECT_EQ(printable("\xEF\xBF\xBF"), "\\xef\\xbf\\xbf");  // U+FFFF, not allowed in XML
}

TEST(Printable, EscapesInvalidUtf8ByteByByte) {
    EXPECT_EQ(printable("\x80"), "\\x80");  // continuation alone
    EXPECT_EQ(printable("\xC3"), "\\xc3");  // cut short
    EXPECT_EQ(printable("\xC3("), "\\xc3(");
    EXPECT_EQ(printable("\xC0\xAF"), "\\xc0\\xaf");  // overlong
    EXPECT_EQ(printable("\xE0\x80\xAF"), "\\xe0\\x80\\xaf");
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");           // surrogate
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // above U+10FFFF
}

}  // namespace
