// assembly.h - a system's modules with their components, and what is connected to what
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/project/qsys/component.h"
#include "sim/project/qsys/system.h"
#include "sim/verilog/project_error.h"

namespace sim::project::qsys {

// The component of an instance with these parameters.  Nothing: its kind is not known.
using Describe = std::function<std::optional<Component>(const Instance&, const Parameters&)>;

// An interface of an instance.
// A component is of a kind that nothing describes.
class UnknownKind : public ProjectError {
public:
    using ProjectError::ProjectError;
};

struct End {
    const Instance* instance;
    const Component* component;
    const Interface* interface;

    std::string name() const { return instance->name + "." + interface->name; }
    // The wire at a port, in the system's module, whose own ports have one _ between their parts.
    std::string wire(const Port& port) const { return instance->name + "__" + port.name; }
    std::string wire(const char* role) const { return wire(*interface->port(role)); }
    bool is_processors() const;
};

class Assembly {
public:
    // ProjectError: a kind that is not known, or that cannot be simulated.
    Assembly(const System& system, const Describe& describe);

    const System& system() const { return system_; }
    const std::vector<Connection>& connections() const { return connections_; }
    const std::vector<std::string>& notes() const { return notes_; }
    // Verilog and VHDL of the components.
    const std::vector<std::filesystem::path>& sources() const { return sources_; }
    bool has_processor() const;

    [[noreturn]] void fail(const std::string& what) const;

    // "INSTANCE.INTERFACE".  Nothing: there is none.  end(): ProjectError instead.
    std::optional<End> find_end(const std::string& name) const;
    End end(const std::string& name) const;
    // All interfaces, in the order of the file.
    void for_each(const std::function<void(const End&)>& visit) const;
    void for_each(const std::string& type, bool is_start,
                  const std::function<void(const End&)>& visit) const;
    const Export* exported(const End& e) const;  // null: it is not

    // The clock of an interface, by its associatedClock: its wire, and where it comes from in the
    // end, through what only passes it on.
    struct Clock {
        std::string wire, root;
    };
    Clock clock_of(const End& e) const;
    // Of a clock's sink; null: it is not connected.
    const Connection* clock_source(const End& sink) const;
    // The reset of an interface, by its associatedReset, as a condition.
    std::string reset_of(const End& e) const;
    // A reset as a condition that is true while it is active.
    static std::string active_high(const End& e);

private:
    void read_component_of(const Instance& instance, const Describe& describe);
    void leave_out(const Instance& instance, const std::string& why);
    void fill_in_rates(const Describe& describe);
    std::string hertz_of(const End& root) const;
    std::string root_of(const End& sink, unsigned depth = 0) const;

    const System& system_;
    std::map<std::string, Component> components_;  // by instance
    std::set<std::string> silent_;                 // instances
    std::map<std::string, std::string> left_out_;  // instances by the reason
    std::vector<Connection> connections_;          // between those that are not
    std::vector<std::string> notes_;
    std::vector<std::filesystem::path> sources_;
};

}  // namespace sim::project::qsys
