// results.h - what the runs of `de1sim test` have come to, as kept in results.json
//
//   results.json   this, renewed after each run: what --rerun-failed, --times and `merge` read
//   junit.xml      a suite per scenario
//   index.html     all of them for a person
//   runs/NAME/     what the run of the scenario NAME has written
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sim::suite {

struct Failure {
    int line = 0;  // in the scenario; 0: of the run as a whole
    std::string step, detail;
    bool met = false;  // a golden picture that was renewed
};

struct Result {
    std::string name, file;
    int exit_code = -1;  // of `de1sim run`; -1: it did not come to its end
    double wall_s = 0, simulated_s = 0;
    std::string end;                     // "all steps done"
    unsigned points = 1;                 // of the scenario: for --gradescope
    std::string visibility = "visible";  // or "hidden", "after_due_date", "after_published"
    std::vector<Failure> failures;
    std::string said;    // the run's last lines
    std::string folder;  // relative to results.json

    bool passed() const { return exit_code == 0; }
};

struct Results {
    std::vector<Result> all;           // by name
    std::vector<std::string> missing;  // names without a result
    std::vector<std::string> suite;    // names of all, in all shards
    unsigned shard = 1, shards = 1;

    const Result* find(const std::string& name) const;
    // In its place by name; what was there under the name goes.
    void put(Result result);
    std::map<std::string, double> times_s() const;
    // The worst of the exit codes: 130, 2, 1, 0; 1 if something is missing, or a run broke off.
    int exit_code() const;
};

// "line 5: expect LEDs 0000000101: LEDR shows 0000000100", or how the run ended; at most 300 bytes,
// then "...".
std::string first_failure(const Result& result);

// From report.json in the run's folder, as far as there is one.
Result read_run(const std::filesystem::path& folder);
// The same of its text.
Result run_in(std::string_view report);

// results.json in this folder.  std::runtime_error: it is missing, or no such file.
Results read_results(const std::filesystem::path& folder);
// The same of its text; `name` is the file's, for messages.
Results results_in(std::string_view text, const std::string& name);
// The text of results.json.
std::string to_json(const Results& results);
// IoError.
void write_results(const std::filesystem::path& folder, const Results& results);
// junit.xml from those of the runs.  IoError.
void write_junit(const std::filesystem::path& folder, const Results& results);

}  // namespace sim::suite
