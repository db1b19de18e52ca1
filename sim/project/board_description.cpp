#include "sim/project/board_description.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "de1_soc_board.h"
#include "sim/project/settings.h"
#include "sim/project/tools.h"
#include "sim/text/lower.h"

namespace sim::project {

namespace fs = std::filesystem;

// ---- A board ----

std::string BoardSignal::bit(unsigned index) const {
    return width() == 1 ? name : fmt::format("{}[{}]", name, index);
}

const BoardSignal* BoardDescription::signal(std::string_view port) const {
    const std::string wanted = lower(std::string{port});
    for (const BoardSignal& signal : signals)
        if (lower(signal.name) == wanted) return &signal;
    for (const BoardSignal& signal : signals)
        if (signal.others.count(wanted)) return &signal;
    return nullptr;
}

const BoardSignal* BoardDescription::signal_of_bit(const std::string& bit) const {
    const std::string base = bit.substr(0, bit.find('['));
    for (const BoardSignal& signal : signals)
        if (signal.name == base || signal.name == bit) return &signal;
    return nullptr;
}

std::string BoardDescription::wire_of_bit(const std::string& bit) const {
    const BoardSignal* const signal = signal_of_bit(bit);
    for (unsigned n = 0; signal && n < signal->width(); ++n)
        if (signal->bit(n) == bit) return signal->wires[n];
    return {};
}

std::map<std::string, std::string> BoardDescription::signals_by_pin() const {
    std::map<std::string, std::string> by_pin;
    for (const BoardSignal& signal : signals)
        for (unsigned n = 0; n < signal.width(); ++n) by_pin[signal.pins[n]] = signal.bit(n);
    return by_pin;
}

bool BoardDescription::has_device(const std::string& device) const {
    return std::any_of(devices.begin(), devices.end(), [&](const std::string& own) {
        return lower(device).compare(0, own.size(), lower(own)) == 0;
    });
}

bool BoardDescription::has_wire(const std::string& wire) const {
    return std::any_of(signals.begin(), signals.end(), [&](const BoardSignal& signal) {
        return std::count(signal.wires.begin(), signal.wires.end(), wire) > 0;
    });
}

unsigned BoardDescription::wires_named(std::string_view wanted) const {
    std::size_t count = 0;
    for (const BoardSignal& signal : signals)
        count += static_cast<std::size_t>(std::count_if(
            signal.wires.begin(), signal.wires.end(),
            [&](const std::string& wire) { return wire.substr(0, wire.find('[')) == wanted; }));
    return static_cast<unsigned>(count);
}

// ---- Its file ----

namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in{text};
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

std::vector<std::string> columns_of(const std::string& line) {
    std::istringstream in{line};
    std::vector<std::string> columns;
    for (std::string column; std::getline(in, column, '\t');) columns.push_back(column);
    return columns;
}

class BoardReader {
public:
    explicit BoardReader(fs::path file) : file_{std::move(file)} {}

    BoardDescription run(const std::string& text) {
        std::istringstream lines{text};
        for (std::string line; std::getline(lines, line);) {
            ++line_;
            if (!line.empty() && line[0] != '#') read(columns_of(line));
        }
        if (board_.name.empty()) refuse("a line \"board\" with its name", "none");
        if (board_.devices.empty()) refuse("a line \"device\"", "none");
        return std::move(board_);
    }

private:
    [[noreturn]] void refuse(const std::string& expected, const std::string& got) const {
        throw ProjectError{
            fmt::format("{}:{}: expected {}, got {}", file_.string(), line_, expected, got)};
    }

    unsigned long long number(const std::string& text) const {
        unsigned long long value = 0;
        const char* const end = text.data() + text.size();
        if (const auto [after, error] = std::from_chars(text.data(), end, value);
            error != std::errc{} || after != end)
            refuse("a number", '"' + text + '"');
        return value;
    }

    void read(const std::vector<std::string>& columns) {
        const std::string& word = columns[0];
        if (columns.size() < 2) refuse("a tab, and what \"" + word + "\" is", "neither");
        const std::string& value = columns[1];
        const std::vector<std::string> words = words_of(value);
        if (word == "board") {
            board_.name = value;
        } else if (word == "device") {
            board_.devices.push_back(value);
        } else if (word == "registers") {
            board_.registers = number(value);
        } else if (word == "memory") {
            if (words.size() != 5 || words[2] != "of" || words[4] != "bits")
                refuse("memory blocks as \"397 M10K of 10240 bits\"", '"' + value + '"');
            board_.memory_blocks = words[0] + " " + words[1];
            board_.memory_bits = number(words[0]) * number(words[3]);
        } else if (word == "processor") {
            if (value != "HPS") refuse("the processor HPS, or no such line", '"' + value + '"');
            board_.has_processor = true;
        } else if (word == "analog-inputs") {
            board_.analog_inputs = static_cast<unsigned>(number(value));
            if (board_.analog_inputs > 8) refuse("at most 8 inputs", '"' + value + '"');
        } else if (word == "computer") {
            if (value != "DE1-SoC" && value != "DE10-Lite")
                refuse("the computer DE1-SoC or DE10-Lite, or no such line", '"' + value + '"');
            board_.computer = value;
        } else if (word == "hps-lcd") {
            if (value != "NT7534")
                refuse("the controller NT7534, or no such line", '"' + value + '"');
            board_.has_lcd = true;
        } else if (word == "i2c") {
            board_.on_i2c.insert(words.begin(), words.end());
        } else if (word == "other-pins") {
            for (const std::string& pin : words) board_.other_pins.insert("PIN_" + pin);
        } else {
            read_signal(columns);
        }
    }

    void read_signal(const std::vector<std::string>& columns) {
        if (columns.size() < 3)
            refuse("a signal with what it is simulated as, and its pins",
                   fmt::format("{} columns", columns.size()));
        BoardSignal signal{columns[0], Direction::INOUT, {}, {}, {}};
        for (const std::string& pin : words_of(columns[2])) {
            signal.pins.push_back("PIN_" + pin);
            if (!pins_.insert(pin).second) refuse("a pin of its own", pin + ", which is taken");
        }
        if (signal.pins.empty()) refuse("the pins of " + signal.name, "none");
        if (columns.size() > 3)
            for (const std::string& other : words_of(columns[3])) signal.others.insert(other);
        connect(signal, columns[1]);
        board_.signals.push_back(std::move(signal));
    }

    void connect(BoardSignal& signal, const std::string& what) {
        constexpr std::uint64_t FS_PER_US = 1'000'000'000, MOST_MHZ = 1'000;
        const std::vector<std::string> words = words_of(what);
        if (words.size() == 2 && words[1] == "MHz") {
            const unsigned long long mhz = number(words[0]);
            if (mhz == 0 || mhz > MOST_MHZ)
                refuse(fmt::format("1 to {} MHz", MOST_MHZ), '"' + what + '"');
            signal.period_fs = FS_PER_US / mhz;
            signal.direction = Direction::INPUT;
            signal.wires = {signal.name};
            return;
        }
        std::vector<std::string> wires;
        if (what == "-") wires.resize(signal.width());
        for (const std::string& name : what == "-" ? std::vector<std::string>{} : words) {
            const ChipWires* const found = chip_wires_named(name);
            if (!found)
                refuse("wires of chip_wires.def, a clock as \"10 MHz\", or -", '"' + name + '"');
            signal.direction = found->direction;
            const unsigned width = signal.width();
            const unsigned first =  // of a colour's few bits the uppermost is the chip's uppermost
                found->group == WireGroup::COLOURS && words.size() == 1 && width < found->width
                    ? found->width - width
                    : 0;
            for (unsigned n = first; n < found->width; ++n) wires.push_back(found->wire(n));
        }
        if (wires.size() < signal.width())
            refuse(fmt::format("at most {} pins", wires.size()), std::to_string(signal.width()));
        wires.resize(signal.width());
        signal.wires = std::move(wires);
    }

    const fs::path file_;
    BoardDescription board_;
    std::set<std::string> pins_;
    unsigned line_ = 0;
};

}  // namespace

BoardDescription read_board(const fs::path& file) { return BoardReader{file}.run(text_of(file)); }

BoardDescription de1_soc() { return BoardReader{"de1_soc/board.tsv"}.run(DE1_SOC_BOARD); }

std::vector<BoardDescription> all_boards() {
    std::vector<BoardDescription> boards;
    for (const auto& entry : fs::directory_iterator{data_folder() / "rtl/board"})
        if (const fs::path file = entry.path() / "board.tsv"; fs::exists(file))
            boards.push_back(read_board(file));
    std::sort(boards.begin(), boards.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    return boards;
}

}  // namespace sim::project
