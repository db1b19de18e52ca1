#include "sim/live/live_client.h"

#include "sim/board/serial_terminal.h"

namespace sim::live {

void LiveClient::attach(const Access& access) {
    std::function<Inside::Program()> program;
    if (const ProgramRun* const run = access.program)
        program = [run] {
            const auto& frames = run->frames();
            return Inside::Program{run->waiting(),
                                   frames.empty() ? std::nullopt : std::optional{frames.back()}};
        };
    inside_.emplace(access.board, access.processor, access.fabric ? &access.fabric->fpga : nullptr,
                    program);
    view_.on_frame = [this] { inside_->frame_ended(); };
    access.runner.on_terminal = [this](const std::string& part, char byte) {
        view_.terminal(part, byte);
    };
    access.board.parts.for_each<SerialTerminal>(
        [this](const std::string& part, SerialTerminal&) { view_.add_terminal(part); });
    player_.emplace("live_player", access.runner, view_, *inside_, wire_, access.plan);
}

}  // namespace sim::live
