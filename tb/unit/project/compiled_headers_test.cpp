// Verilator's headers, precompiled in the user's cache; here by a compiler that is a script.
#include "sim/project/compiled_headers.h"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/files/whole_file.h"
#include "sim/project/settings.h"
#include "sim/project/verilator.h"

namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;

class CompiledHeaders : public ::testing::Test {
protected:
    CompiledHeaders() {
        fs::remove_all(folder);
        fs::create_directories(folder / "bin");
        fs::create_directories(folder / "objects");
        write("verilated.h", "one");
        compiler("");
        setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
        setenv("PATH", ((folder / "bin").string() + ":/usr/bin:/bin").c_str(), 1);
    }
    ~CompiledHeaders() override { fs::remove_all(folder); }

    void write(const char* name, const std::string& text) const {
        std::ofstream{folder / name} << text;
    }
    // Says that it has read verilated.h, and counts how often it has precompiled something.
    void compiler(const std::string& otherwise) const {
        write("bin/g++", "#!/bin/sh\ncase \"$*\" in\n*c++-header*) echo made >> '" + made.string() +
                             "'; echo x > new; echo 'new: a.h " +
                             (folder / "verilated.h").string() + "' > rule; touch a.h;;\n*) " +
                             otherwise + "true;;\nesac\n");
        fs::permissions(folder / "bin/g++", fs::perms::owner_all);
    }
    int times() const {
        std::ifstream lines{made};
        int count = 0;
        for (std::string line; std::getline(lines, line);) ++count;
        return count;
    }
    std::vector<std::string> words(const std::string& option = "-O2") const {
        return sim::project::compiled_headers({"g++", option}, limit);
    }

    const fs::path folder = fs::path{::testing::TempDir()} / "compiled_headers" /
                            ::testing::UnitTest::GetInstance()->current_test_info()->name();
    const fs::path made = folder / "made";
    const sim::project::TimeLimit limit{60};
};

TEST_F(CompiledHeaders, AreMadeOnce) {
    const auto first = words();
    EXPECT_THAT(first, ElementsAre("-include", EndsWith(".h")));
    EXPECT_TRUE(fs::exists(first[1] + ".gch"));
    EXPECT_EQ(words(), first);
    EXPECT_EQ(times(), 1);
}

TEST_F(CompiledHeaders, AreMadeAnewWhenAHeaderHasChanged) {
    words();
    write("verilated.h", "another");
    words();
    EXPECT_EQ(times(), 2);
    fs::last_write_time(folder / "verilated.h", fs::file_time_type{});
    words();
    EXPECT_EQ(times(), 3);
}

TEST_F(CompiledHeaders, AreMadeAnewForAnotherCompilerAndOtherOptions) {
    const auto first = words();
    compiler("echo another;");
    EXPECT_NE(words(), first);
    EXPECT_EQ(times(), 2);
    words("-O1");
    EXPECT_EQ(times(), 3);
    EXPECT_FALSE(fs::exists(first[1] + ".gch"));  // one is enough
    EXPECT_TRUE(fs::exists(first[1]));            // for whoever is just using it
}

TEST_F(CompiledHeaders, AreMadeAnewWhenTheyAreNotWhole) {
    const auto first = words();
    fs::resize_file(first[1] + ".gch", 1);
    EXPECT_EQ(words(), first);
    EXPECT_EQ(times(), 2);
}

TEST_F(CompiledHeaders, AreLeftOutWithoutACacheOrACompiler) {
    setenv("XDG_CACHE_HOME", "/proc/none", 1);
    EXPECT_THAT(words(), IsEmpty());
    setenv("XDG_CACHE_HOME", "", 1);
    unsetenv("HOME");
    EXPECT_THAT(words(), IsEmpty());
    setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    write("bin/g++", "#!/bin/sh\nexit 1\n");
    EXPECT_THAT(words(), IsEmpty());
    setenv("PATH", "", 1);
    EXPECT_THAT(words(), IsEmpty());
}

TEST_F(CompiledHeaders, AreForgottenWhenADesignDoesNotCompileWithThem) {
    const auto compile = [&] {
        sim::project::compile_library(folder, folder / "objects", false,
                                      sim::project::find_verilator(limit), limit);
    };
    compiler("case \"$*\" in *-include*/headers/*) exit 1;; esac;");
    EXPECT_THROW(compile(), sim::project::ProjectError) << "no model of a known form";
    std::ofstream{folder / "objects/Vde1sim_chip___024root__0.cpp"}
        << "void Vde1sim_chip___024root___eval_triggers_vec__act(";
    compile();
    compile();
    EXPECT_EQ(times(), 2);
    compiler("case \"$*\" in *fast.cxx*) exit 1;; esac;");
    EXPECT_THROW(compile(), sim::project::ProjectError);
}

}  // namespace
