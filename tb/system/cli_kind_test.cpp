// cli_kind_test.cpp - a file that is no program and no scenario gets a message for its kind.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class OtherFile : public tb::CommandLine {
protected:
    // de1sim FILE, and the line that it refuses it by.
    std::string refusal(const std::string& name, const std::string& content = "x\n",
                        std::vector<std::string> arguments = {}) const {
        if (!name.empty()) folder.put(name, content);
        arguments.push_back(folder / name);
        arguments.insert(arguments.end(), {"--out", out.string()});
        const tb::Outcome outcome = de1sim(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(tb::lines_of(outcome.err), SizeIs(1));
        EXPECT_FALSE(std::filesystem::exists(out));
        return outcome.err;
    }
    // Does what the line for `name` says after "for example: ".
    tb::Outcome obey(const std::string& name, const std::string& content) const {
        const std::string said = refusal(name, content), before = "for example: ";
        const std::size_t at = said.find(before);
        EXPECT_NE(at, std::string::npos) << said;
        tb::Command command;
        command.shell = "cd '" + folder.path().string() + "'; de1sim() { '" DE1SIM "' \"$@\"; }; " +
                        said.substr(at + before.size());
        command.arguments = {"/bin/true"};
        return tb::run_program(command);
    }
};

TEST_F(OtherFile, OfCIsBuiltByTheSuggestedCommand) {
    EXPECT_THAT(
        obey("a b.c", "#include <stdio.h>\nint main(void) { printf(\"c %d\\n\", 1); }\n").out,
        HasSubstr("c 1\na b.elf: the program ended"));
}

TEST_F(OtherFile, OfCxxIsBuiltByTheSuggestedCommand) {
    EXPECT_THAT(obey("a b.cpp", "#include <cstdio>\nint main() { std::puts(\"c++\"); }\n").out,
                HasSubstr("c++\na b.elf: the program ended"));
}

TEST_F(OtherFile, OfAssemblyIsBuiltByTheSuggestedCommand) {
    EXPECT_THAT(obey("a b.s",
                     ".global _start\n_start: ldr r0, =0xFF200000\n mov r1, #5\n"
                     " str r1, [r0]\n cpsid if\n b .\n")
                    .out,
                HasSubstr("LEDR 0000000101"));
}

TEST_F(OtherFile, OfCForLinuxSuggestsTheLinuxCompiler) {
    EXPECT_THAT(refusal("p.c", "#include <sys/mman.h>\n"),
                HasSubstr("p.c: is C source, not a program: build it, for the board's Linux: "
                          "arm-linux-gnueabihf-gcc -static "));
}

TEST_F(OtherFile, OfMemoryIsAnImageOfAProgram) {
    EXPECT_THAT(refusal("p.bin", std::string(9, '\0')), HasSubstr("is an image of memory"));
    EXPECT_THAT(refusal("p.hex", ":00000001FF\n"), HasSubstr("is an image of memory in text"));
    EXPECT_THAT(refusal("p.srec"), HasSubstr("run the ELF file that it was made of ("));
}

TEST_F(OtherFile, OfADesignNamesTheProjectBesideIt) {
    folder.put("pong.qsf", "");
    const std::string runs = "de1sim live --project " + (folder / "pong.qsf").string() + ", or ";
    EXPECT_THAT(refusal("top.v"), HasSubstr("top.v: is a design's source"));
    EXPECT_THAT(refusal("top.SV"), HasSubstr(runs));
    EXPECT_THAT(refusal("top.sof", "\x01\x02"),
                HasSubstr("is a bitstream; de1sim runs the design"));
    EXPECT_THAT(refusal("top.vhd"), HasSubstr(runs));
    EXPECT_THAT(refusal("pong.qpf"), HasSubstr("is a Quartus project: de1sim live --project "));
    EXPECT_THAT(refusal("top.amp"), HasSubstr("is a project of Intel's Monitor Program: copy "));
}

TEST_F(OtherFile, OfAnotherKindIsRecognisedByItsBytes) {
    EXPECT_THAT(refusal("p", "\x89PNG\r\n"), HasSubstr("is a picture, not a program (ELF file)"));
    EXPECT_THAT(refusal("p", "!<arch>\n"), HasSubstr("is a library, not a program"));
    EXPECT_THAT(refusal("p", std::string("a\0b", 3)),
                HasSubstr("is neither a program (ELF file) nor a scenario (YAML)"));
}

TEST_F(OtherFile, ThatIsAFolderOrMissingIsReported) {
    EXPECT_THAT(refusal(""), HasSubstr("is a folder: for one of scenarios: de1sim test "));
    EXPECT_THAT(de1sim({"run", folder / "none"}).err, HasSubstr("none: is not there\n"));
    EXPECT_THAT(de1sim({folder / "none.elf"}).err, HasSubstr("none.elf: is not there\n"));
}

TEST_F(OtherFile, InTheProgramsPlaceGetsTheSameMessage) {
    scenario("duration: 1ms\n");
    folder.put("p.c", "int main;\n");
    for (const auto& arguments :
         {std::vector<std::string>{"run", folder / "s.yaml", "--elf"}, {"live", "--elf"}}) {
        std::vector<std::string> all = arguments;
        all.push_back(folder / "p.c");
        const tb::Outcome outcome = de1sim(all);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, HasSubstr("p.c: is C source, not a program: build it"));
    }
    EXPECT_THAT(de1sim({"run", "s.yaml", "--elf", folder / "s.yaml"}).err,
                HasSubstr("s.yaml: is a scenario, not a program (ELF file)"));
}

}  // namespace
