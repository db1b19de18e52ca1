#include "sim/project/generated.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/project/settings.h"

namespace sim::project {

namespace {

// As the text of a string in C++.
std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += (c == '"' || c == '\\' ? "\\" : "") + std::string{c};
    return safe;
}

// Who sees a clock.
struct Seen {
    bool rises, falls;  // by the design, or as a level by the board
    unsigned pins;      // bits of clocks_o that it drives
};

// A pin that is none of clocks_o is seen as a level; one that nothing simulates, not at all.
Seen seen(const std::optional<ClockUses::Use>& use, const Binding& binding) {
    if (!use) return {true, true, 0};
    unsigned pins = 0;
    for (const auto& [name, bit] : use->pins) {
        const auto bound = std::find_if(binding.ports.begin(), binding.ports.end(),
                                        [&](const auto& port) { return port.port.name == name; });
        if (bound == binding.ports.end()) return {true, true, 0};
        const std::string& wire = bound->bits.at(bound->bits.size() - 1 - bit).wire;
        if (wire.empty()) continue;
        const unsigned in_clocks = lsb_of(ChipPort::clocks_o, wire);
        if (in_clocks == NO_BIT) return {true, true, 0};
        pins |= 1u << in_clocks;
    }
    const bool rises = use->rises || use->locks;
    return {rises, rises && pins != 0, pins};
}

bool is_seen(const PllClock& clock, const Binding& binding) {
    const Seen by = seen(clock.use, binding);
    return by.rises || by.pins != 0;
}

bool is_pins_alone(const PllClock& clock, const Binding& binding) {
    const Seen by = seen(clock.use, binding);
    return !by.rises && by.pins != 0;
}

bool only_rises(const PllClock& clock, const Binding& binding) {
    const Seen by = seen(clock.use, binding);
    return by.rises && !by.falls && !clock.is_settable;
}

// Of de1sim_chip.v: what a pin has that rises with CLOCK_50, while its fall is left out.
constexpr const char* HIGH_AT_CLOCK_50 = "high_at_clock_50";

// What sees CLOCK_50, but for PLLs that are not locked.
Seen seen_of_clock_50(const Elaborated& elaborated, const Binding& binding) {
    static const std::set<std::string> CLOCKS{"CLOCK_50", "CLOCK2_50", "CLOCK3_50", "CLOCK4_50"};
    Seen all{false, false, 0};
    for (const auto& [wire, by] : binding.connected) {
        if (CLOCKS.count(by)) return {true, true, 0};
        if (by == HIGH_AT_CLOCK_50) all.pins |= 1u << lsb_of(ChipPort::clocks_o, wire);
    }
    for (const auto& [port, bits] : binding.ports)
        for (const auto& bit : bits) {
            if (!CLOCKS.count(bit.wire)) continue;
            const auto use = elaborated.input_uses.find(port.name);
            if (use == elaborated.input_uses.end()) return {true, true, 0};
            auto without_locks = use->second;
            without_locks.locks = false;
            const Seen by = seen(without_locks, binding);
            if (by.falls || by.pins) return {true, true, 0};
            all.rises |= by.rises;
        }
    return all;
}

// Of a clock of the board that is none of the chip's wires.
std::optional<ClockUses::Use> use_of(const std::string& signal, const Elaborated& elaborated,
                                     const Binding& binding) {
    ClockUses::Use all;
    for (const auto& [port, bits] : binding.ports)
        for (const auto& bit : bits) {
            if (bit.signal != signal) continue;
            const auto use = elaborated.input_uses.find(port.name);
            if (use == elaborated.input_uses.end() || !use->second.pins.empty()) return {};
            all.rises |= use->second.rises || use->second.locks;
        }
    return all;
}

// A clock by an input of the chip.
std::string clock_text(const std::string& input, const char* output, bool only_rises) {
    return only_rises ? fmt::format("de1sim_clock_pulse pulse({}, {});", input, output)
                      : fmt::format("assign {} = {};", output, input);
}

// The instances of the processor's UARTs that the settings have placed, with their numbers.
std::string placed_uarts(const Project& project) {
    std::string text;
    for (const auto& [instance, site] : project.processor_places)
        for (const auto& [number, place] :
             {std::pair{0, "UART_X52_Y66_"}, std::pair{1, "UART_X52_Y67_"}})
            if (site.find(place) != std::string::npos)
                text += fmt::format("{{\"{}\", {}}}, ", escaped(instance), number);
    return text;
}

constexpr std::uint64_t LEAST_SAMPLE_FS = 6'000'000, CLOCK_50_FS = 20'000'000;

}  // namespace

void add_board_clocks(const BoardDescription& board, Elaborated& elaborated, Binding& binding) {
    std::vector<PllClock>& all = elaborated.pll_clocks;
    const auto monitor = binding.connected.find("VGA_CLK");
    std::uint64_t shortest_fs = CLOCK_50_FS;
    PllClock* sampling = nullptr;
    for (std::size_t n = 0; n < all.size() && monitor != binding.connected.end(); ++n) {
        if (all[n].period_fs >= shortest_fs || all[n].period_fs < LEAST_SAMPLE_FS ||
            is_pins_alone(all[n], binding))
            continue;
        shortest_fs = all[n].period_fs;
        monitor->second = fmt::format("pll_clocks[{}]", n);
        sampling = &all[n];
    }
    if (sampling) sampling->use.reset();
    if (monitor != binding.connected.end() && monitor->second == "CLOCK_50") {
        monitor->second = HIGH_AT_CLOCK_50;
        if (seen_of_clock_50(elaborated, binding).falls) monitor->second = "CLOCK_50";
    }
    for (auto& [name, number] : binding.clocks) {
        const std::uint64_t period_fs = board.signal(name)->period_fs;
        const PllClock clock{period_fs, 0,      period_fs / 2,
                             false,     {name}, use_of(name, elaborated, binding)};
        auto same = std::find(all.begin(), all.end(), clock);
        if (same == all.end())
            same = all.insert(all.end(), clock);
        else
            same->use.reset();
        if (is_seen(*same, binding))
            same->use.reset();  // it is that input itself, not a pulse of it
        same->names.insert(name);
        number = static_cast<unsigned>(same - all.begin());
    }
}

void write_if_new(const std::filesystem::path& file, const std::string& text) {
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && text_of(file) == text) return;
    write_whole_file(file, text);
}

std::string tap_text(const Elaborated& elaborated, const Binding& binding) {
    const std::vector<PllClock>& clocks = elaborated.pll_clocks;
    std::string text =
        "// Written by de1sim: CLOCK_50 and the PLLs' outputs, as inputs of the chip.\n"
        "module de1sim_clock_50(input wire clk_i, output wire clk_o);\n    " +
        clock_text("clk_i", "clk_o", !seen_of_clock_50(elaborated, binding).falls) +
        "\nendmodule\n"
        "module de1sim_pll_tap #(\n"
        "    parameter [63:0] PERIOD_FS = 64'd0,\n"
        "    parameter [63:0] PHASE_FS  = 64'd0,\n"
        "    parameter [63:0] HIGH_FS   = 64'd0,\n"
        "    parameter [63:0] SETTABLE  = 64'd0\n"
        ") (\n    output wire clk,\n    input wire set_i,\n"
        "    input wire [63:0] period_fs_i, high_fs_i\n);\n";
    if (std::any_of(clocks.begin(), clocks.end(), [](const auto& c) { return c.is_settable; }))
        text +=
            "    import \"DPI-C\" function void de1sim_pll_set(\n"
            "        input int number, input longint period_fs, input longint high_fs);\n";
    text += "    generate\n";
    for (std::size_t n = 0; n < clocks.size(); ++n)
        text += fmt::format(
            "        if (PERIOD_FS == 64'd{0} && PHASE_FS == 64'd{1} && HIGH_FS == 64'd{2} &&\n"
            "            SETTABLE == 64'd{3}) begin\n"
            "            {6}\n{5}        end\n",
            clocks[n].period_fs, clocks[n].phase_fs, clocks[n].high_fs,
            clocks[n].is_settable ? 1 : 0, n,
            clocks[n].is_settable ? fmt::format("            always @(posedge set_i) "
                                                "de1sim_pll_set({}, period_fs_i, high_fs_i);\n",
                                                n)
                                  : "",
            clock_text(fmt::format("de1sim_chip.pll_clocks[{}]", n), "clk",
                       only_rises(clocks[n], binding)));
    return text + "    endgenerate\nendmodule\n";
}

std::string facts_text(const Project& project, const Elaborated& elaborated,
                       const Binding& binding) {
    std::set<std::string> below;  // from the project's folder on
    for (const SourceFile& file : project.sources)
        below.insert(file.path.parent_path().lexically_relative(project.folder).string());
    std::string folders;
    for (const std::string& folder : below) folders += fmt::format("\"{}\", ", escaped(folder));
    std::string text =
        "// Written by de1sim.\n#pragma once\n"
        "constexpr sim::project::PllTimes PLL_CLOCKS[] = {";
    for (const PllClock& clock : elaborated.pll_clocks)
        text += fmt::format("{{{}ull, {}ull, {}ull, {}, {}, {}}}, ", clock.period_fs,
                            clock.phase_fs, clock.high_fs,
                            is_pins_alone(clock, binding) ? seen(clock.use, binding).pins : 0,
                            only_rises(clock, binding), is_seen(clock, binding));
    const Seen clock_50 = seen_of_clock_50(elaborated, binding);
    return text + fmt::format(
                      "{{0, 0, 0, 0, false, false}}}};\nconstexpr unsigned PLL_CLOCK_COUNT = {};\n"
                      "constexpr bool CLOCK_50_ONLY_RISES = {}, CLOCK_50_SEEN = {};\n"
                      "constexpr unsigned CLOCK_50_PINS = {};\n"
                      "constexpr bool TD_CLK27_USED = {}, VGA_USED = {};\n"
                      "constexpr bool AUD_XCK_USED = {}, AUD_CLOCKS_DRIVEN = {};\n"
                      "constexpr const char* SOURCE_FOLDERS[] = {{{}\"\"}};\n"
                      "constexpr unsigned SOURCE_FOLDER_COUNT = {};\n"
                      "constexpr sim::project::PlacedUart PLACED_UARTS[] = {{{}{{\"\", 0}}}};\n",
                      elaborated.pll_clocks.size(), !clock_50.falls, clock_50.rises, clock_50.pins,
                      binding.has_td_clk, binding.has_vga, binding.has_xck,
                      binding.drives_codec_clocks, folders, below.size(), placed_uarts(project));
}

std::string loops_text(const std::string& output, const std::string& otherwise) {
    std::string loops;
    std::istringstream lines{output};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t quote = line.find("'de1sim_chip.de1sim_design.");
        if (line.find("Warning-UNOPTFLAT: ") == std::string::npos || quote == std::string::npos)
            continue;
        const std::size_t place = line.find(": ") + 2, begin = line.find('.', quote + 14) + 1;
        const std::string name = line.substr(begin, line.find('\'', begin) - begin);
        if (name.find("__V") != std::string::npos) continue;  // of Verilator's making
        const std::size_t column = line.find(':', line.find(':', place) + 1);
        loops += fmt::format("{}{} ({})", loops.empty() ? "" : ", ", name,
                             line.substr(place, column - place));
    }
    if (loops.empty()) loops = otherwise;
    if (!loops.empty()) loops += " depends on itself without a register";
    return fmt::format("// Written by de1sim.\n#pragma once\nconstexpr char LOOPS[] = \"{}\";\n",
                       escaped(loops));
}

}  // namespace sim::project
