#include "sim/live/inside.h"

#include <nlohmann/json.hpp>

#include "regmap.h"

namespace sim::live {

namespace {

constexpr unsigned FIFO_SIZE =
    regmap::AUDIO_FIFOSPACE_RESET >> regmap::AUDIO_FIFOSPACE_WSLC_LSB & 0xff;

}  // namespace

void Inside::frame_ended() {
    if (!processor_) return;
    const BusCounts now = processor_->processor_bus().counts();
    frame_ = {now.reads - then_.reads, now.writes - then_.writes, now.bursts - then_.bursts, 0};
    then_ = now;
}

nlohmann::json Inside::look() const {
    nlohmann::json all{{"frames", board_.monitor.frames()},
                       {"pictures", board_.monitor.new_pictures()},
                       {"signal", board_.monitor.signal()},
                       {"vga_violations", board_.monitor.violations()},
                       {"sdram_violations", board_.sdram_chip.violations()},
                       {"codec_errors", board_.codec_chip.error_count()}};
    if (!processor_) return all;
    all["bus"] = {{"reads", frame_.reads},
                  {"writes", frame_.writes},
                  {"bursts", frame_.bursts},
                  {"errors", processor_->processor_bus().counts().errors}};
    if (const auto audio = fabric_ ? fabric_->audio() : std::nullopt)
        all["audio"] = {{"to_play", audio->to_play},
                        {"recorded", audio->recorded},
                        {"size", FIFO_SIZE},
                        {"underruns", audio->underruns}};
    ProgramCpu* const cpu = processor_->program_cpu();
    if (!cpu || !program_) return all;
    const ProgramCpu::Position at = cpu->position();
    const ProgramCpu::Counts counts = cpu->counts();
    const Program more = program_();
    nlohmann::json& program = all["program"] = {{"pc", at.pc},
                                                {"function", at.function},
                                                {"waiting", more.waiting},
                                                {"interrupts", counts.interrupts},
                                                {"aborts", counts.aborts}};
    if (more.frame) {
        program["busy"] = more.frame->busy_share;
        program["on_bus"] = more.frame->bus_share;
        program["instructions"] = more.frame->instructions;
    }
    return all;
}

std::vector<std::string> Inside::new_violations() {
    std::vector<std::string> lines;
    const std::pair<const char*, const std::vector<std::string>&> parts[] = {
        {"VGA: ", board_.monitor.messages()},
        {"SDRAM: ", board_.sdram_chip.messages()},
        {"codec: ", board_.codec_chip.errors()}};
    std::size_t* sent = sent_;
    for (const auto& [part, messages] : parts) {
        for (; *sent < messages.size(); ++*sent) lines.push_back(part + messages[*sent]);
        ++sent;
    }
    return lines;
}

}  // namespace sim::live
