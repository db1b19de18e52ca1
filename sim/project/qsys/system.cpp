#include "sim/project/qsys/system.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "sim/project/qsys/verilog_text.h"
#include "sim/project/settings.h"
#include "sim/text/printable.h"

namespace sim::project::qsys {

namespace fs = std::filesystem;

namespace {

// A parameter's value is an attribute, or the element's text.
std::string value_of(const pugi::xml_node& parameter) {
    const pugi::xml_attribute value = parameter.attribute("value");
    return value ? value.value() : parameter.child_value();
}

std::map<std::string, std::string> parameters_of(const pugi::xml_node& node) {
    std::map<std::string, std::string> all;
    for (const pugi::xml_node& parameter : node.children("parameter"))
        all[parameter.attribute("name").value()] = value_of(parameter);
    return all;
}

Connection::Kind kind_of(const std::string& name) {
    static const std::map<std::string, Connection::Kind> KINDS{
        {"avalon", Connection::Kind::AVALON},
        {"clock", Connection::Kind::CLOCK},
        {"reset", Connection::Kind::RESET},
        {"interrupt", Connection::Kind::INTERRUPT},
        {"conduit", Connection::Kind::CONDUIT},
        {"avalon_streaming", Connection::Kind::STREAMING},
        {"tristate_conduit", Connection::Kind::CONDUIT}};
    const auto found = KINDS.find(name);
    return found == KINDS.end() ? Connection::Kind::OTHER : found->second;
}

class SystemReader {
public:
    SystemReader(const std::string& text, const fs::path& file) : text_{text} {
        system_.file = file;
        system_.name = file.stem().string();
    }

    System run() {
        pugi::xml_document document;
        const pugi::xml_parse_result result = document.load_string(text_.c_str());
        if (!result)
            fail(result.offset, std::string{"this is broken XML: "} + result.description());
        const pugi::xml_node system = document.child("system");
        if (!system) fail(0, "this is no Platform Designer system: it has no element `system`");
        for (const pugi::xml_node& node : system.children("module")) add_instance(node);
        for (const pugi::xml_node& node : system.children("connection")) add_connection(node);
        for (const pugi::xml_node& node : system.children("interface")) add_export(node);
        return std::move(system_);
    }

private:
    [[noreturn]] void fail(std::ptrdiff_t offset, const std::string& what) const {
        const auto end = text_.begin() + std::min<std::ptrdiff_t>(
                                             offset, static_cast<std::ptrdiff_t>(text_.size()));
        throw ProjectError{printable(fmt::format("{}:{}: {}", system_.file.filename().string(),
                                                 1 + std::count(text_.begin(), end, '\n'), what))};
    }

    void need_name(const pugi::xml_node& node, const std::string& name) const {
        if (!is_name(name))
            fail(node.offset_debug(),
                 fmt::format("the name `{}`, expected letters, digits and _", name));
    }

    void add_instance(const pugi::xml_node& node) {
        Instance instance{node.attribute("name").value(), node.attribute("kind").value(),
                          node.attribute("version").value(), parameters_of(node)};
        constexpr std::string_view OWN_NAME = "$${FILENAME}";
        for (auto& [name, value] : instance.parameters)
            for (std::size_t at; (at = value.find(OWN_NAME)) != std::string::npos;)
                value.replace(at, OWN_NAME.size(), system_.name);
        if (instance.name.empty() || instance.kind.empty())
            fail(node.offset_debug(), "a module has no name or no kind");
        need_name(node, instance.name);
        if (!known_.insert(instance.name).second)
            fail(node.offset_debug(), "there are two modules " + instance.name);
        if (std::string_view{node.attribute("enabled").value()} == "0") return;
        if (system_.instances.size() == MOST_INSTANCES)
            fail(node.offset_debug(), fmt::format("more than {} modules", MOST_INSTANCES));
        enabled_.insert(instance.name);
        system_.instances.push_back(std::move(instance));
    }

    void add_connection(const pugi::xml_node& node) {
        Connection c{kind_of(node.attribute("kind").value()), node.attribute("start").value(),
                     node.attribute("end").value()};
        for (const std::string& side : {c.start, c.end})
            if (!known_.count(instance_of(side)))
                fail(node.offset_debug(),
                     fmt::format("a connection names {}, but there is no such module", side));
        if (!enabled_.count(instance_of(c.start)) || !enabled_.count(instance_of(c.end))) return;
        const auto parameters = parameters_of(node);
        const auto number = [&](const char* name, std::uint64_t otherwise) {
            const auto found = parameters.find(name);
            return found == parameters.end() ? otherwise
                                             : std::strtoull(found->second.c_str(), nullptr, 0);
        };
        c.base = number("baseAddress", 0);
        c.interrupt = static_cast<unsigned>(number("irqNumber", 0));
        c.shares = static_cast<unsigned>(
            std::clamp<std::uint64_t>(number("arbitrationPriority", 1), 1, 100));
        system_.connections.push_back(std::move(c));
    }

    void add_export(const pugi::xml_node& node) {
        const std::string internal = node.attribute("internal").value();
        const pugi::xml_attribute type = node.attribute("type"), direction = node.attribute("dir");
        if (!type || !direction) return;
        if (!enabled_.count(instance_of(internal))) return;
        need_name(node, node.attribute("name").value());
        system_.exports.push_back({node.attribute("name").value(), internal, type.value(),
                                   std::string_view{direction.value()} == "start"});
    }

    const std::string& text_;
    System system_;
    std::set<std::string> known_, enabled_;  // instances
};

}  // namespace

std::string instance_of(const std::string& interface) {
    return interface.substr(0, interface.find('.'));
}

System system_in(const std::string& text, const fs::path& file) {
    return SystemReader{text, file}.run();
}

System read_system(const fs::path& file) { return system_in(text_of(file), file); }

}  // namespace sim::project::qsys
