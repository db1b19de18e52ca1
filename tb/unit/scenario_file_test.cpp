// scenario_file_test.cpp - scenarios that cannot be read, and their golden pictures
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sim/files/png.h"
#include "tb/support/temp_folder.h"
#include "tb/unit/scenario_errors.h"

namespace {

using namespace sim;
using namespace tb;
using testing::EndsWith;

class ScenarioFile : public testing::Test {
protected:
    std::string load(const std::string& text) {
        folder.put("a.yaml", text);
        return load_error(folder / "a.yaml");
    }
    std::string at(const std::string& message) { return (folder / "a.yaml").string() + message; }

    TempFolder folder;
    const std::string expect = "name: a\nversion: 1\nsteps:\n- expect-frame:\n    equals: g.png\n";
};

TEST_F(ScenarioFile, IsRefusedIfMissingOrAFolderOrAPipe) {
    EXPECT_EQ(load_error(folder / "b.yaml"), (folder / "b.yaml").string() + ": is not there");
    EXPECT_EQ(load_error(folder.path()),
              folder.path().string() + ": expected a scenario file, got: is a folder");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(load_error(folder / "pipe"), EndsWith("got: is not a file"));
    EXPECT_THAT(load_error("/dev/zero"), EndsWith("got: is not a file"));
    folder.put("x", "");
    EXPECT_THAT(load_error(folder / "x/a.yaml"), EndsWith("got: cannot read: Not a directory"));
}

TEST_F(ScenarioFile, IsRefusedWhenItCanNotBeRead) {
    folder.put("a.yaml", "name: a");
    std::filesystem::permissions(folder / "a.yaml", std::filesystem::perms::none);
    if (access((folder / "a.yaml").c_str(), R_OK) == 0)  // root reads everything
        EXPECT_EQ(load_error("/proc/self/mem"),
                  "/proc/self/mem: expected a scenario, got an empty file");
    else
        EXPECT_EQ(load_error(folder / "a.yaml"),
                  at(": expected a scenario file, got: cannot read: Permission denied"));
}

TEST_F(ScenarioFile, IsRefusedWhenItIsLargerThanAMebibyte) {
    EXPECT_EQ(load(std::string((1u << 20) + 1, '#')),
              at(": expected a scenario file, got: is larger than 1048576 bytes"));
}

TEST_F(ScenarioFile, IsRefusedWithoutItsGoldenPicture) {
    const std::string place = at(":4:3: expected a picture, got ");
    const std::string png = (folder / "g.png").string();
    EXPECT_EQ(load(expect), place + png + ": is not there");
    folder.put("g.png", "hello");
    EXPECT_EQ(load(expect), place + png + ": not a PNG");
    write_png(folder / "g.png", Image{640, 480, std::vector<std::uint8_t>(640 * 480 * 3)});
    EXPECT_EQ(load(expect), "no error");
}

}  // namespace
