// A scenario is refused with a place in it, or read; what is read can be written with one step more
// and is read as the same steps.
#include <algorithm>

#include "sim/scenario/continued.h"
#include "sim/scenario/scenario.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

void must_be_in(const sim::ScenarioError& error, std::string_view text) {
    must_be_a_line(error.what());
    const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
    must(error.line >= 0 && error.line <= lines + 1, "an error's line is in the file");
    must(error.column >= 0, "a column is not negative");
}

}  // namespace

void try_scenario(std::string_view input) {
    sim::Scenario read;
    try {
        read = sim::parse_scenario(input, "folder/s.yaml");
    } catch (const sim::ScenarioError& error) {
        return must_be_in(error, input);
    }
    must(read.text == input, "the text is kept");
    must(!read.steps.empty() || read.duration, "a scenario has steps or a duration");
    for (const sim::ScenarioStep& step : read.steps) must_be_a_line(step.text);
    const std::string written = sim::continued(read, read.seed, "folder", {"delay: 1ms"});
    sim::Scenario again;
    try {
        again = sim::parse_scenario(written, "folder/s.yaml");
    } catch (const sim::ScenarioError& error) {
        must_be_a_line(error.what());
        must(false, ("a scenario that is written is read: " + std::string{error.what()}).c_str());
    }
    must(again.steps.size() == read.steps.size() + 1, "no step is lost");
    for (std::size_t i = 0; i < read.steps.size(); ++i)
        must(again.steps[i].text == read.steps[i].text, "a step is written as it was");
    must(again.name == read.name && again.seed == read.seed &&
             again.parts.size() == read.parts.size(),
         "a scenario is written as it was");
}

}  // namespace fuzz
