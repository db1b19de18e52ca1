// message.h - what Quartus would say of a design: number, place, and the sense in own words.
#pragma once

#include <string>
#include <vector>

namespace sim::project {

struct Place {
    std::string file;  // as in messages
    unsigned line = 0;
    std::string text() const { return file + ":" + std::to_string(line); }
};

struct Message {
    unsigned number;   // of Quartus' messages: 10240
    std::string file;  // from the project's folder; empty: of the whole design
    unsigned line;
    std::string text;

    std::string place() const { return file + ":" + std::to_string(line); }
    bool operator<(const Message& o) const {
        if (file != o.file) return file < o.file;
        if (line != o.line) return line < o.line;
        return number != o.number ? number < o.number : text < o.text;
    }
    bool operator==(const Message& o) const { return !(*this < o) && !(o < *this); }
};
using Messages = std::vector<Message>;

// "top.v:8: 10240: ..."
std::string line_of(const Message& message);

}  // namespace sim::project
