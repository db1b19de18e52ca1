// choose_board.cpp - which board a project is for
#include <algorithm>

#include <fmt/format.h>

#include "sim/project/board_description.h"
#include "sim/project/settings.h"
#include "sim/text/lower.h"

namespace sim::project {

namespace {

using Boards = std::vector<BoardDescription>;
using Pins = std::map<std::string, std::string>;

constexpr const char* PRESET = "DE1-SoC";

// "DE10-Lite", "de10_lite" and "de10lite" are one.
std::string plain(const std::string& name) {
    std::string letters;
    for (const char c : lower(name))
        if (c != '-' && c != '_' && c != ' ') letters += c;
    return letters;
}

// "DE1-SoC (5CSEMA5F31C6), DE10-Lite (10M50DAF484)"
std::string list_of(const Boards& boards) {
    std::string list;
    for (const BoardDescription& board : boards)
        list +=
            fmt::format("{}{} ({})", list.empty() ? "" : ", ", board.name, board.devices.front());
    return list;
}

// Assigned pins at which the board has the signal of that name.
std::size_t count_of_pins(const BoardDescription& board, const Pins& pins) {
    const auto by_pin = board.signals_by_pin();
    return static_cast<std::size_t>(
        std::count_if(pins.begin(), pins.end(), [&](const auto& assigned) {
            const auto at = by_pin.find(assigned.second);
            if (at == by_pin.end()) return false;
            const std::string &name = assigned.first, &bit = at->second;
            const std::size_t index = name.find('[');
            const BoardSignal* const signal = board.signal(name.substr(0, index));
            if (!signal || signal != board.signal_of_bit(bit)) return false;
            const std::size_t own = bit.find('[');
            return index == std::string::npos || own == std::string::npos ||
                   name.substr(index) == bit.substr(own);
        }));
}

// Those of the most pins, if these are more than half of the assigned ones.
Boards by_pins(const Boards& boards, const Pins& pins) {
    Boards best;
    std::size_t most = pins.size() / 2;
    for (const BoardDescription& board : boards) {
        const std::size_t count = count_of_pins(board, pins);
        if (count > most) best.clear();
        if (count > most || (count == most && !best.empty())) best.push_back(board);
        most = std::max(most, count);
    }
    return best;
}

std::string other_device(const BoardDescription& board, const std::string& device) {
    return fmt::format("DEVICE is {}, not the {}'s {}", device, board.name, board.devices.front());
}

}  // namespace

BoardDescription board_named(const Boards& boards, const std::string& name) {
    for (const BoardDescription& board : boards)
        if (plain(board.name) == plain(name)) return board;
    throw ProjectError{
        fmt::format("board {}: there is no such board: expected one of {}", name, list_of(boards))};
}

BoardChoice choose_board(const Boards& boards, const BoardRequest& request) {
    const auto is_of = [&](const BoardDescription& board) {
        return request.device.empty() || board.has_device(request.device);
    };
    if (!request.name.empty()) {
        BoardChoice choice{board_named(boards, request.name), false, {}};
        if (is_of(choice.board) || !by_pins({choice.board}, request.pins).empty()) return choice;
        choice.is_for_other_device = true;
        choice.notes = {other_device(choice.board, request.device) + ": ports go by their names"};
        return choice;
    }
    Boards possible;
    if (!request.device.empty())
        std::copy_if(boards.begin(), boards.end(), std::back_inserter(possible), is_of);
    const Boards best = by_pins(boards, request.pins);
    if (possible.size() > 1) {
        const Boards among = by_pins(possible, request.pins);
        if (among.size() != 1)
            throw ProjectError{
                fmt::format("DEVICE is {}, which several boards have, and the pins do not tell "
                            "which: choose by --board, or in the scenario by `board:`: {}",
                            request.device, list_of(among.empty() ? possible : among))};
        return {among.front(), false, {}};
    }
    const bool pins_tell = best.size() == 1;
    if (possible.size() == 1) {
        const BoardDescription& board = possible.front();
        if (!pins_tell || best.front().name == board.name ||
            !by_pins({board}, request.pins).empty())
            return {board, false, {}};
        return {best.front(),
                false,
                {fmt::format("DEVICE is the {}'s {}, but the pins are those of the {}, which is "
                             "taken; --board chooses another",
                             board.name, request.device, best.front().name)}};
    }
    if (pins_tell && request.device.empty()) return {best.front(), false, {}};
    if (pins_tell)
        return {best.front(),
                false,
                {other_device(best.front(), request.device) + ", but the pins are those of it"}};
    const BoardDescription preset = board_named(boards, PRESET);
    if (request.device.empty()) return {preset, false, {}};
    return {preset,
            true,
            {fmt::format("{}: ports go by their names; --board chooses another board of {}",
                         other_device(preset, request.device), list_of(boards))}};
}

}  // namespace sim::project
