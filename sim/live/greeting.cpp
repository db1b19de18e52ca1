#include "sim/live/greeting.h"

#include <nlohmann/json.hpp>

namespace sim::live {

using nlohmann::json;

void Greeting::take(const std::string& text) {
    const json message = json::parse(text, nullptr, false);
    if (message.contains("lamps")) lamps_ = text;
    if (message.contains("log") || message.contains("fault") || message.contains("violation")) {
        events_.push_back(text);
        if (events_.size() > MOST_EVENTS) events_.pop_front();
    }
    if (message.contains("console")) {
        console_ += message["console"].get<std::string>();
        if (console_.size() > MOST_PRINTED) console_.erase(0, console_.size() - MOST_PRINTED / 2);
    }
}

std::deque<std::string> Greeting::texts() const {
    std::deque<std::string> all = events_;
    if (!lamps_.empty()) all.push_back(lamps_);
    if (!console_.empty())
        all.push_back(
            json{{"console", console_}}.dump(-1, ' ', false, json::error_handler_t::replace));
    return all;
}

}  // namespace sim::live
