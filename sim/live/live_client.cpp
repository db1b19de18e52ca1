#include "sim/live/live_client.h"

namespace sim::live {

void LiveClient::attach(const Access& access) {
    std::function<Inside::Program()> program;
    if (const ProgramRun* const run = access.program)
        program = [run] {
            const auto& frames = run->frames();
            return Inside::Program{run->waiting(),
                                   frames.empty() ? std::nullopt : std::optional{frames.back()}};
        };
    inside_.emplace(access.board, access.processor,
                    access.fabric ? &access.fabric->fabric : nullptr, program);
    view_.on_frame = [this] { inside_->frame_ended(); };
    access.runner.on_terminal = [this](const std::string& part, char byte) {
        view_.terminal(part, byte);
    };
    parts_.emplace(access.board.parts, access.plan.scenario.parts, wire_);
    player_.emplace("live_player", access.runner, view_, *parts_, *inside_, wire_, access.plan);
}

}  // namespace sim::live
