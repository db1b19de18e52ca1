// What de1sim reads of its own files and of what programs print: TAP, report.json, results.json.
// The first byte says which.
#include <stdexcept>

#include "sim/report/compare.h"
#include "sim/report/tap.h"
#include "sim/suite/results.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

using namespace sim::suite;

void try_tap(std::string_view text) {
    sim::TapReader reader;
    for (const char c : text) reader.print(c);
    const auto checks = reader.checks();
    must(checks.empty() || text.find("TAP version 13") != std::string_view::npos,
         "there are no checks without the first line");
    for (const sim::Check& check : checks) must(!check.name.empty(), "a check has a name");
    must(reader.checks().size() == checks.size(), "asking changes nothing");
}

void try_compare(std::string_view text) {
    try {
        must(sim::differences(text, "a", text, "b").empty(), "a report is equal to itself");
    } catch (const std::runtime_error& error) {
        must_be_a_line(error.what());
    }
}

void try_results(std::string_view text) {
    try {
        const std::string written = to_json(results_in(text, "results.json"));
        must(to_json(results_in(written, "again")) == written, "results are written as they were");
    } catch (const std::runtime_error& error) {
        must_be_a_line(error.what());
    }
}

}  // namespace

void try_report(std::string_view input) {
    switch (next_byte(input) % 4) {
        case 0: return try_tap(input);
        case 1: return try_compare(input);
        case 2: return try_results(input);
        default: (void)run_in(input);
    }
}

}  // namespace fuzz
