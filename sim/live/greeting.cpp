#include "sim/live/greeting.h"

#include <nlohmann/json.hpp>

namespace sim::live {

using nlohmann::json;

namespace {

constexpr std::size_t MOST_PRINTED = 64 << 10;

void append(std::string& to, const std::string& text) {
    to += text;
    if (to.size() > MOST_PRINTED) to.erase(0, to.size() - MOST_PRINTED / 2);
}

std::string text_of(const json& message) {
    return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

void Greeting::add(const std::string& text) {
    const json message = json::parse(text, nullptr, false);
    if (message.contains("lamps")) lamps_ = text;
    if (message.contains("board")) board_ = text;
    if (message.contains("ended")) ended_ = text;
    if (message.contains("parts")) parts_.merge_patch(message["parts"]);
    if (message.contains("log") || message.contains("fault") || message.contains("violation")) {
        events_.push_back(text);
        if (events_.size() > MOST_EVENTS) events_.pop_front();
    }
    if (message.contains("console")) append(console_, message["console"].get<std::string>());
    if (message.contains("terminals"))
        for (const auto& [line, printed] : message["terminals"].items())
            append(terminals_[line], printed.get<std::string>());
}

std::deque<std::string> Greeting::texts() const {
    std::deque<std::string> all = events_;
    if (!board_.empty()) all.push_back(board_);
    if (!lamps_.empty()) all.push_back(lamps_);
    if (!parts_.empty()) all.push_back(text_of({{"parts", parts_}}));
    if (!console_.empty()) all.push_back(text_of({{"console", console_}}));
    if (!terminals_.empty()) all.push_back(text_of({{"terminals", terminals_}}));
    if (!ended_.empty()) all.push_back(ended_);
    return all;
}

}  // namespace sim::live
