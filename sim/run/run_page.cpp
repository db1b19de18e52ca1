// run_page.cpp - see run_page.h
#include "sim/run/run_page.h"

#include <algorithm>

#include "sim/run/version.h"

namespace sim {

namespace {

constexpr unsigned MOST_PICTURES = 60;  // that steps have saved; the others are files only
constexpr std::size_t MAX_PNG_BYTES = 8u << 20;

}  // namespace

RunPage::RunPage(const RunDescription& run, Recorder& recorder)
    : recorder_{recorder}, file_{run.outputs.html} {
    recorder.page = &page_;
    page_.command = run.command;
    page_.version = VERSION;
}

void RunPage::step_done() { frame_of_step_.push_back(page_.film.keep(recorder_.observations())); }

void RunPage::write(const RunReport& report, const Scenario& scenario, const ScenarioRunner& runner,
                    const ProgramRun* program) {
    auto result = report.expectations.begin();
    unsigned pictures = 0;
    for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
        const ScenarioStep& step = scenario.steps[i];
        page::Page::Step shown{step.line, step.text};
        if (i < frame_of_step_.size()) shown.frame = frame_of_step_[i];
        if (i < runner.played().size()) {
            const ScenarioRunner::Played& played = runner.played()[i];
            shown.begun = true;
            shown.from_s = played.from_s;
            shown.to_s = std::max(played.to_s, played.from_s);
            for (const auto& path : played.saved)
                if (pictures++ < MOST_PICTURES) {
                    const std::string bytes = read_whole_file(path, MAX_PNG_BYTES);
                    shown.pictures.push_back(
                        {path.filename().string(), {bytes.begin(), bytes.end()}});
                }
        }
        if (step.step->decides() && result != report.expectations.end()) {
            shown.met = result->met;
            shown.detail = result->detail;
            ++result;
        }
        page_.steps.push_back(std::move(shown));
    }
    if (program) page_.frames = program->frames();
    const std::string text = to_html(report, page_);
    file_.write(text.data(), text.size());
    file_.commit();
}

}  // namespace sim
