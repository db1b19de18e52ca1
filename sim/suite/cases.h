// cases.h - the scenarios of `de1sim test`: which there are, and how they are split among machines
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sim::suite {

struct Case {
    std::filesystem::path file;
    std::string name;       // unique: the file without .yaml, as it was found
    double expected_s = 0;  // of wall time; an estimate where it has not been measured
    unsigned points = 1;
    std::string visibility = "visible";
    // Whose program or project it judges, and that, in place of the scenario's; or empty.
    std::string hand_in{};
    std::filesystem::path program{}, project{};
};

// All scenarios under the paths, by name, each once.  A path is a file, or a folder in which every
// .yaml file with `steps:`, or with `name:` and `version:`, is one.  Folders that begin with a dot
// and those that a run has written (with a report.json) are left out.  std::runtime_error: a path
// is missing, or there is no scenario.
std::vector<Case> find_cases(const std::vector<std::filesystem::path>& paths);

// Those whose name contains the text, or matches it if it has *, ? or [ as in a shell.
std::vector<Case> filtered(std::vector<Case> cases, const std::string& text);

// The wall seconds that earlier runs have measured, by name, in the place of the estimates.
void use_times(std::vector<Case>& cases, const std::map<std::string, double>& times_s);

// Longest first; by name where they are equal.
void sort_by_time(std::vector<Case>& cases);

// Part `number`, 1 to `count`, of about the same length as the others: the next longest case always
// goes to the part that has least.  The same on every machine, for the same cases.
std::vector<Case> shard(std::vector<Case> cases, unsigned number, unsigned count);

}  // namespace sim::suite
