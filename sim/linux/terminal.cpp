#include "sim/linux/terminal.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iterator>

namespace sim {

namespace {

constexpr char END = 4, BACKSPACE = 8, DELETE = 127;
// Bytes of struct termios.
constexpr std::size_t LOCAL = 12, CONTROL = 17, VINTR = CONTROL, VQUIT = CONTROL + 1,
                      VMIN = CONTROL + 6, VSUSP = CONTROL + 10;
constexpr std::uint8_t ISIG = 1, ICANON = 2, ECHO = 8, NOFLSH = 0x80;
const sc_core::sc_time character_time{1, sc_core::SC_MS};
const sc_core::sc_time forever{8'640'000, sc_core::SC_SEC};  // 100 days; SystemC's time is finite

// struct termios of a console at 115,200 baud: modes, line discipline, control characters.
Terminal::Settings console_settings() {
    constexpr std::uint32_t MODES[4] = {0x500, 5, 0x1CB2, 0x8A3B};  // input, output, control, local
    Terminal::Settings settings{};
    std::memcpy(settings.data(), MODES, sizeof MODES);
    // VINTR, VQUIT, VERASE, VKILL, VEOF, VTIME, VMIN, VSWTC, VSTART, VSTOP, VSUSP, VEOL, VREPRINT,
    // VDISCARD, VWERASE, VLNEXT
    constexpr std::uint8_t CHARACTERS[] = {3,  28, 127, 21, 4,  0,  1,  0,
                                           17, 19, 26,  0,  18, 15, 23, 22};
    std::copy(std::begin(CHARACTERS), std::end(CHARACTERS), settings.begin() + CONTROL);
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
    if (outside_.typed) outside_.typed();
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

std::int64_t Terminal::give(char* to, std::size_t bytes) {
    const std::size_t count = std::min(bytes, line_.size());
    std::memcpy(to, line_.data(), count);
    line_.erase(0, count);
    return static_cast<std::int64_t>(count);
}

std::int64_t Terminal::read(char* to, std::size_t bytes) {
    std::int64_t count;
    while ((count = read_now(to, bytes)) == -EAGAIN) doze(forever);
    return count;
}

std::int64_t Terminal::read_now(char* to, std::size_t bytes) {
    if (bytes == 0) return 0;
    if (!line_.empty()) return give(to, bytes);
    std::size_t count = unit();
    if (!arrived(count)) {
        if (count == 0 && closed_) return 0;
        return !by_line() && settings[VMIN] == 0 ? 0 : -EAGAIN;
    }
    seen_ -= std::min(seen_, count);
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
    return give(to, bytes);
}

void Terminal::flush() {
    line_.clear();
    while (arrived(std::min<std::size_t>(typed_.size(), 1))) {
        typed_.pop_front();
        seen_ -= std::min<std::size_t>(seen_, 1);
    }
}

// ---- Signals ------------------------------------------------------------------------------------

// 0: none.  A control character 0 is switched off.
unsigned Terminal::signal_of(char c) const {
    if (!(settings[LOCAL] & ISIG) || !outside_.signal || c == 0) return 0;
    const auto is = [&](std::size_t which) {
        return settings[which] == static_cast<std::uint8_t>(c);
    };
    return is(VINTR) ? SIGINT : is(VQUIT) ? SIGQUIT : is(VSUSP) ? SIGTSTP : 0;
}

bool Terminal::arrive() {
    const std::size_t before = seen_;
    bool come = false;
    while (seen_ < typed_.size() && arrived(seen_ + 1)) {
        const char c = typed_[seen_++].character;
        come = true;
        const unsigned number = signal_of(c);
        if (number == 0) continue;
        if (settings[LOCAL] & NOFLSH) {
            typed_.erase(typed_.begin() + static_cast<std::ptrdiff_t>(--seen_));
        } else {
            line_.clear();
            typed_.erase(typed_.begin(), typed_.begin() + static_cast<std::ptrdiff_t>(seen_));
            seen_ = 0;
        }
        if (settings[LOCAL] & ECHO) {
            outside_.echo('^');
            outside_.echo(static_cast<char>(c ^ 0x40));
        }
        outside_.signal(number);
    }
    return come || before != seen_;
}

std::optional<sc_core::sc_time> Terminal::next_arrival() const {
    if (seen_ >= typed_.size()) return std::nullopt;
    return typed_[seen_].at;
}

}  // namespace sim
