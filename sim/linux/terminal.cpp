#include "sim/linux/terminal.h"

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

constexpr char END = 4, BACKSPACE = 8, DELETE = 127;
constexpr std::size_t LOCAL = 12, VMIN = 17 + 6;  // bytes of struct termios
constexpr std::uint8_t ICANON = 2, ECHO = 8;
const sc_core::sc_time character_time{1, sc_core::SC_MS};
const sc_core::sc_time forever{8'640'000, sc_core::SC_SEC};  // 100 days; SystemC's time is finite

// struct termios of a console at 115,200 baud: modes, line discipline, control characters.
Terminal::Settings console_settings() {
    constexpr std::uint32_t MODES[4] = {0x500, 5, 0x1CB2, 0x8A3B};  // input, output, control, local
    Terminal::Settings settings{};
    std::memcpy(settings.data(), MODES, sizeof MODES);
    settings[VMIN] = 1;
    return settings;
}

bool ends_line(char c) { return c == '\n' || c == END; }

}  // namespace

Terminal::Terminal(Outside outside) : settings{console_settings()}, outside_{std::move(outside)} {}

void Terminal::type(const std::string& text) {
    sc_core::sc_time at = sc_core::sc_time_stamp();
    if (!typed_.empty()) at = std::max(at, typed_.back().at);
    for (const char c : text) typed_.push_back({c == '\r' ? '\n' : c, at += character_time});
    more_.notify(sc_core::SC_ZERO_TIME);
}

bool Terminal::by_line() const { return settings[LOCAL] & ICANON; }

bool Terminal::arrived(std::size_t count) const {
    return count > 0 && typed_[count - 1].at <= outside_.now();
}

// Characters of the next line, or 1 without ICANON; 0 if they are not typed yet.
std::size_t Terminal::unit() const {
    if (!by_line()) return typed_.empty() ? 0 : 1;
    const auto end = std::find_if(typed_.begin(), typed_.end(),
                                  [](const Key& key) { return ends_line(key.character); });
    return end == typed_.end() ? 0 : static_cast<std::size_t>(end - typed_.begin()) + 1;
}

std::uint32_t Terminal::ready() const {
    if (!line_.empty()) return static_cast<std::uint32_t>(line_.size());
    const std::size_t count = unit();
    return arrived(count) ? static_cast<std::uint32_t>(count) : 0;
}

bool Terminal::readable() const { return ready() > 0 || (closed_ && unit() == 0); }

// Sleeps until something new is typed, or what was typed has arrived.
void Terminal::doze(const sc_core::sc_time& at_most) {
    const std::size_t count = unit();
    waits_ = true;
    if (count == 0)
        outside_.sleep_until(more_, at_most);
    else
        outside_.sleep(std::min(at_most, typed_[count - 1].at - outside_.now()));
    waits_ = false;
}

void Terminal::wait(const sc_core::sc_time& at_most) {
    const sc_core::sc_time end = outside_.now() + at_most;
    while (!readable() && outside_.now() < end) doze(end - outside_.now());
}

std::int64_t Terminal::take(char* to, std::size_t bytes) {
    const std::size_t count = std::min(bytes, line_.size());
    std::memcpy(to, line_.data(), count);
    line_.erase(0, count);
    return static_cast<std::int64_t>(count);
}

std::int64_t Terminal::read(char* to, std::size_t bytes) {
    if (bytes == 0) return 0;
    if (!line_.empty()) return take(to, bytes);
    std::size_t count = 0;
    while (!arrived(count = unit())) {
        if (count == 0 && closed_) return 0;
        if (!by_line() && settings[VMIN] == 0) return 0;
        doze(forever);
    }
    for (; count > 0; --count) {
        const char c = typed_.front().character;
        typed_.pop_front();
        if (by_line() && c == END) break;
        if (by_line() && (c == BACKSPACE || c == DELETE)) {
            if (!line_.empty()) line_.pop_back();
        } else {
            line_ += c;
        }
    }
    if (settings[LOCAL] & ECHO)
        for (const char c : line_) outside_.echo(c);
    return take(to, bytes);
}

}  // namespace sim
