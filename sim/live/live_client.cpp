#include "sim/live/live_client.h"

namespace sim::live {

void LiveClient::attach(const Parts& parts) {
    std::function<Inside::Program()> program;
    if (const ArmRun* const arm = parts.arm)
        program = [arm] {
            const auto& frames = arm->frames();
            return Inside::Program{arm->waiting(),
                                   frames.empty() ? std::nullopt : std::optional{frames.back()}};
        };
    inside_.emplace(parts.board, parts.processor, parts.computer ? &parts.computer->fpga : nullptr,
                    program);
    view_.on_frame = [this] { inside_->frame_ended(); };
    parts.runner.on_terminal = [this](const std::string& part, char byte) {
        view_.terminal(part, byte);
    };
    parts.board.parts.for_each_terminal(
        [this](const std::string& part, SerialTerminal&) { view_.add_terminal(part); });
    player_.emplace("live_player", parts.runner, view_, *inside_, wire_, parts.plan);
}

}  // namespace sim::live
