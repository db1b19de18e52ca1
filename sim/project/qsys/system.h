// system.h - a system of Platform Designer (Qsys), as its .qsys file has it
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sim::project::qsys {

constexpr std::size_t MOST_INSTANCES = 10'000;

struct Instance {
    std::string name, kind, version;
    std::map<std::string, std::string> parameters;
};

// Between two interfaces, each "INSTANCE.INTERFACE".
struct Connection {
    enum class Kind { AVALON, CLOCK, RESET, INTERRUPT, CONDUIT, STREAMING, OTHER };
    Kind kind;
    std::string start, end;
    std::uint64_t base = 0;  // AVALON: bytes, in the master's addresses
    unsigned interrupt = 0;  // INTERRUPT: its number at the receiver
    unsigned shares = 1;     // AVALON: of the arbiter's turns
};

std::string instance_of(const std::string& interface);

struct Export {
    std::string name, internal;  // "led", "pio_0.external_connection"
    std::string type;            // conduit, clock, avalon ...
    bool is_start;
};

struct System {
    std::filesystem::path file;
    std::string name;                 // of its module: that of the file
    std::vector<Instance> instances;  // that are enabled
    std::vector<Connection> connections;
    std::vector<Export> exports;  // that have a type: the others are left over from what was there
};

// ProjectError: the file cannot be read or is no such system; for another family of devices.
System read_system(const std::filesystem::path& file);
// The same of the file's text.
System system_in(const std::string& text, const std::filesystem::path& file);

}  // namespace sim::project::qsys
