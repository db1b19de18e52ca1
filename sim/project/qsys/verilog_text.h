// verilog_text.h - the text of a module that is being written: its wires, and what is below them
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>

namespace sim::project::qsys {

// Whether it can be a part of a name in Verilog.  Platform Designer has no others.
inline bool is_name(const std::string& text) {
    const auto is_part = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), is_part) &&
           !std::isdigit(static_cast<unsigned char>(text[0]));
}

struct VerilogText {
    std::string wires, body;

    void line(const std::string& text) { body += "    " + text + "\n"; }
    void section(const std::string& title) {
        constexpr std::size_t WIDTH = 70;
        body += fmt::format("\n    // ---- {} {}\n", title,
                            std::string(title.size() + 2 < WIDTH ? WIDTH - title.size() : 2, '-'));
    }
    // `is_vector`: also where the width is 1.
    void wire(const std::string& name, unsigned width, bool is_vector = false) {
        wires += fmt::format("    wire {}{};\n", range(width, is_vector || width != 1), name);
    }
    static std::string range(unsigned width, bool is_vector) {
        return is_vector ? fmt::format("[{}:0] ", width - 1) : "";
    }
};

}  // namespace sim::project::qsys
