// netlist.h - who drives and who reads each variable of an elaborated design, from Verilator's XML.
//
// Of each module there is one for each set of its parameters.  The XML is that of -O0, in which
// nothing is optimised away.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "sim/verilog/quartus/message.h"

namespace sim::project {

struct Driver {
    enum class Kind { ASSIGN, ALWAYS, INSTANCE, INITIAL, TASK };
    Kind kind;
    unsigned process;  // a number of the assign, block or instance
    Place place;
    unsigned low, high;    // bits
    long element;          // of an array, or -1: it is not known, or no array
    bool exact;            // the bits are known
    bool high_z;           // may release the wire
    bool blocking;         // "=" in a block
    std::string value;     // of an assign, as the XML has it
    std::string of, port;  // of an instance: module and port
    std::string instance;
};

struct Variable {
    std::string name;  // as written
    Place place;
    std::string direction;  // input, output, inout or empty
    unsigned width = 1;
    unsigned long long words = 1;  // of an array
    int left = 0, right = 0;
    bool is_vector = false, is_array = false, is_integer = false;
    bool has_own_type = false;                    // of a typedef or an enumeration
    bool is_parameter = false, is_local = false;  // local: of a block, a function or a task
    bool is_loop_variable = false, has_pull = false;
    std::vector<Driver> drivers;
    std::set<unsigned> readers;  // processes
    unsigned reads = 0;
};

struct Connection {
    std::string port, direction;
    bool is_open;
};
struct Instance {
    std::string name, of;  // of: Netlist::modules' key
    Place place;
    std::vector<Connection> connections;
};

struct NetModule {
    std::string name;  // as written
    Place place;
    bool is_top = false;
    bool is_own = false;  // the project's, and no model's or VHDL's
    std::vector<Variable> variables;
    std::map<std::string, std::size_t> ports;       // to variables
    std::map<std::string, std::string> port_names;  // of __pinNumber1 and so on
    std::vector<Instance> instances;
    std::vector<pugi::xml_node> blocks;  // always
    pugi::xml_node node;
};

class Netlist {
public:
    // ProjectError.
    explicit Netlist(const std::string& tree_file);

    const std::map<std::string, NetModule>& modules() const { return modules_; }
    // Of a node's "loc".
    Place place(const pugi::xml_node& node) const;
    unsigned width(const pugi::xml_node& node) const;
    // Whether the port of a module drives what it is connected with, always.
    bool drives(const std::string& module, const std::string& port, unsigned depth = 0) const;

private:
    struct Type {
        unsigned width = 1;
        unsigned long long words = 1;
        int left = 0, right = 0;
        bool is_vector = false, is_array = false, is_integer = false;
    };
    friend class NetlistReader;
    void name_port(std::string& port, const std::string& module) const;
    void read_types(const pugi::xml_node& table);

    pugi::xml_document document_;
    std::map<std::string, std::string> files_;  // by the letter of a "loc"
    std::map<std::string, Type> types_;
    std::map<std::string, NetModule> modules_;
};

bool is_node(const pugi::xml_node& node, std::string_view name);
// The number of a constant, "4'h5"; -1: there is an x or z in it, or it is too large.
long long constant(const pugi::xml_node& node);
bool has_z(const pugi::xml_node& node);

}  // namespace sim::project
