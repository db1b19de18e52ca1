// cli.h - test fixture: de1sim on the command line, and the folder that it writes into.
#pragma once

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tb/support/run_program.h"
#include "tb/support/temp_folder.h"

namespace tb {

class CommandLine : public ::testing::Test {
protected:
    const TempFolder folder;  // with the scenarios
    const std::filesystem::path out = folder / "out";

    // Runs `de1sim WORDS...`; a word that ends in .yaml is a file in `folder`.
    Outcome de1sim(std::vector<std::string> arguments, Command command = {}) const {
        arguments.insert(arguments.begin(), DE1SIM);
        return start(std::move(arguments), std::move(command));
    }
    // Runs `PROGRAM run SCENARIO --out OUT WORDS...`.
    Outcome play(const std::string& scenario, const std::vector<std::string>& arguments = {},
                 Command command = {}, const std::string& program = DE1SIM) const {
        std::vector<std::string> all{program, "run", scenario, "--out", out.string()};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return start(std::move(all), std::move(command));
    }

    // Writes a scenario of these lines and returns its name.
    std::string scenario(const std::string& lines, const std::string& name = "s.yaml") const {
        folder.put(name, "name: test\nversion: 1\n" + lines);
        return name;
    }

    std::string file(const std::string& name) const { return folder.get("out/" + name); }
    nlohmann::json report() const { return nlohmann::json::parse(file("report.json")); }

    // Paths of the regular files under `out`, relative to it.
    std::set<std::string> files() const {
        std::set<std::string> names;
        if (std::filesystem::is_directory(out))
            for (const auto& entry : std::filesystem::recursive_directory_iterator(out))
                if (entry.is_regular_file())
                    names.insert(entry.path().lexically_relative(out).string());
        return names;
    }
    static std::string frame(unsigned number) {
        std::string digits = std::to_string(number);
        return "frames/frame_" + std::string(6 - digits.size(), '0') + digits + ".png";
    }

private:
    Outcome start(std::vector<std::string> arguments, Command command) const {
        for (std::string& word : arguments)
            if (std::filesystem::path{word}.extension() == ".yaml" && word[0] != '/')
                word = (folder / word).string();
        command.arguments = std::move(arguments);
        Outcome outcome = run_program(command);
        EXPECT_FALSE(outcome.timed_out) << outcome.err;
        return outcome;
    }
};

}  // namespace tb
