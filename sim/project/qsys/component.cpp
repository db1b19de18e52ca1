#include "sim/project/qsys/component.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <list>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "sim/project/qsys/interface_forms.h"
#include "sim/project/qsys/verilog_text.h"
#include "sim/project/safe_tcl.h"
#include "sim/project/settings.h"
#include "sim/text/lower.h"
#include "sim/text/printable.h"

namespace sim::project::qsys {

namespace fs = std::filesystem;

namespace {

using Words = SafeTcl::Words;

struct Parameter {
    std::string type = "INTEGER", value;
    std::map<std::string, std::string> properties;
};

// As Verilog has it.
std::string literal(const Parameter& p) {
    const std::string type = lower(p.type);
    const std::string& value = p.value;
    if (type == "string" || type == "string_list") return '"' + value + '"';
    if (type == "boolean") return lower(value) == "true" || value == "1" ? "1" : "0";
    if (type == "std_logic_vector" || type == "long" || type == "natural" || type == "positive" ||
        type == "integer" || type == "std_logic") {
        char* end = nullptr;
        const long long number = std::strtoll(value.c_str(), &end, 0);
        if (*end == '\0' && end != value.c_str()) {
            const auto property = p.properties.find("WIDTH");
            const int width =
                property == p.properties.end() ? 0 : std::atoi(property->second.c_str());
            if (width > 0 && width < 64)  // negative, it is that of the same bits
                return fmt::format("{}'d{}", width,
                                   static_cast<unsigned long long>(number) & ((1ull << width) - 1));
            return std::to_string(number);
        }
        if (value.find('\'') != std::string::npos) return value;  // 8'hff
    }
    if (type == "float") return value;
    return '"' + value + '"';
}

class ComponentReader {
public:
    ComponentReader(const std::string& text, const fs::path& file, const Parameters& parameters,
                    const std::string& instance)
        : text_{text}, given_{parameters}, instance_{instance}, script_{file.filename().string()} {
        component_.file = file;
        for (const auto& [name, method] : METHODS)
            tcl_.add(name, [this, command = method](const Words& words) {
                return (this->*command)(words);
            });
        for (const char* name : SILENT) tcl_.add(name, [](const Words&) { return ""; });
        tcl_.add("pwd", [this](const Words&) { return folder().string(); });
        tcl_.add("unknown", [this](const Words& words) -> std::string {
            fail(fmt::format("the command {} is not one that describes a component",
                             words.size() > 1 ? words[1] : ""));
        });
    }

    Component run() {
        execute(text_);
        for (const char* callback : {"VALIDATION_CALLBACK", "ELABORATION_CALLBACK"})
            if (const std::string name = property_of_module(callback); !name.empty())
                guarded([&] { tcl_.run(name); });
        component_.kind = property_of_module("NAME");
        component_.version = property_of_module("VERSION");
        add_files();
        for (const auto& [name, p] : parameters_)
            if (is_true(p, "HDL_PARAMETER")) component_.parameters[name] = literal(p);
        for (Interface& i : component_.interfaces)
            for (Port& port : i.ports) set_width(port);
        make_apb_avalon(component_.interfaces);
        part_resets(component_.interfaces);
        return std::move(component_);
    }

private:
    using Method = std::string (ComponentReader::*)(const Words&);

    // ---- Execution ----

    [[noreturn]] void fail_of_file(const std::string& what) const {
        throw ProjectError{printable(component_.file.filename().string() + ": " + what)};
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw ProjectError{printable(fmt::format("{}:{}: {}", script_, line_, what))};
    }

    template <class Action>
    void guarded(Action action) {
        try {
            action();
        } catch (const ProjectError&) {
            throw;
        } catch (const std::exception& error) {
            fail(std::string{"this is wrong Tcl: "} + error.what());
        }
    }

    void execute(std::string text) {
        text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
        std::replace(text.begin(), text.end(), '\0', ' ');
        line_ = 1;
        const auto count = [&](std::size_t from, std::size_t to) {
            line_ += static_cast<unsigned>(
                std::count(text.begin() + static_cast<std::ptrdiff_t>(from),
                           text.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
        };
        for (std::size_t at = 0; at < text.size();) {
            SafeTcl::Extent extent{};
            guarded([&] { extent = tcl_.next_command(text, at); });
            count(at, extent.begin);
            if (!extent.is_empty)
                guarded([&] { tcl_.run(text.substr(extent.begin, extent.end - extent.begin)); });
            count(extent.begin, extent.end);
            at = extent.end;
        }
    }

    void need(const Words& words, std::size_t count) const {
        if (words.size() > count) return;
        fail(fmt::format("{} needs {} words, has {}", words[0], count, words.size() - 1));
    }

    // ---- Commands ----

    // A script that several descriptions share; its name is relative to theirs.
    std::string source(const Words& words) {
        need(words, 1);
        constexpr unsigned MOST = 100;
        const fs::path file = component_.file.parent_path() / words.back();
        std::error_code error;
        if (!fs::is_regular_file(file, error)) fail("there is no file " + words.back());
        if (++sourced_ > MOST)
            fail(fmt::format("more than {} files are sourced; does one source itself?", MOST));
        const auto [script, line] = std::pair{script_, line_};
        script_ = file.filename().string();
        execute(text_of(file));
        script_ = script;
        line_ = line;
        return {};
    }

    fs::path folder() const { return fs::absolute(component_.file).parent_path(); }
    std::string of_file(const Words& words) {
        need(words, 2);
        const auto result = file_result(words, folder());
        if (!result) fail("`file " + words[1] + "` is not for the description of a component");
        return *result;
    }

    std::string set_module_property(const Words& words) {
        need(words, 2);
        module_properties_[words[1]] = words[2];
        return {};
    }
    std::string get_module_property(const Words& words) {
        need(words, 1);
        return property_of_module(words[1]);
    }
    std::string property_of_module(const std::string& name) const {
        const auto found = module_properties_.find(name);
        return found == module_properties_.end() ? "" : found->second;
    }

    std::string add_parameter(const Words& words) {
        need(words, 1);
        Parameter& p = parameters_[words[1]];
        if (words.size() > 2) p.type = words[2];
        if (words.size() > 3) p.properties["DEFAULT_VALUE"] = p.value = words[3];
        set_given(words[1], p);
        return words[1];
    }
    void set_given(const std::string& name, Parameter& p) const {
        if (const auto given = given_.find(name); given != given_.end()) p.value = given->second;
    }
    Parameter& parameter(const std::string& name) {
        const auto found = parameters_.find(name);
        if (found != parameters_.end()) return found->second;
        fail("there is no parameter " + name);
    }
    std::string set_parameter_property(const Words& words) {
        need(words, 3);
        Parameter& p = parameter(words[1]);
        p.properties[words[2]] = words[3];
        if (words[2] == "TYPE") p.type = words[3];
        if (words[2] == "DEFAULT_VALUE") {
            p.value = words[3];
            set_given(words[1], p);
        }
        return {};
    }
    std::string get_parameter_property(const Words& words) {
        need(words, 2);
        return parameter(words[1]).properties[words[2]];
    }
    std::string get_parameter_value(const Words& words) {
        need(words, 1);
        return parameter(words[1]).value;
    }
    std::string set_parameter_value(const Words& words) {
        need(words, 2);
        parameter(words[1]).value = words[2];
        return {};
    }
    std::string get_parameters(const Words&) {
        std::string all;
        for (const auto& [name, p] : parameters_) all += (all.empty() ? "" : " ") + name;
        return all;
    }
    bool is_true(const Parameter& p, const char* property) const {
        const auto found = p.properties.find(property);
        return found != p.properties.end() &&
               (lower(found->second) == "true" || found->second == "1");
    }

    std::string add_fileset(const Words& words) {
        need(words, 2);
        filesets_.push_back({words[1], words[2], words.size() > 3 ? words[3] : "", "", {}});
        return {};
    }
    std::string set_fileset_property(const Words& words) {
        need(words, 3);
        for (Fileset& f : filesets_)
            if (f.name == words[1] && lower(words[2]) == "top_level") f.top = words[3];
        return {};
    }
    // add_fileset_file NAME TYPE PATH path ?TOP_LEVEL_FILE?
    std::string add_fileset_file(const Words& words) {
        need(words, 3);
        if (filesets_.empty()) return {};
        Fileset& fileset = callback_fileset_ ? *callback_fileset_ : filesets_.back();
        if (words[3] == "PATH" && words.size() > 4)
            fileset.files.push_back(
                {words[4], words[2],
                 std::find(words.begin() + 5, words.end(), "TOP_LEVEL_FILE") != words.end()});
        return {};
    }
    // As components were described before Quartus 12.
    std::string add_file(const Words& words) {
        need(words, 1);
        old_files_.push_back({words[1], "", false});
        return {};
    }

    void need_name(const std::string& name) const {
        if (!is_name(name))
            fail(fmt::format("the name `{}`, expected letters, digits and _", name));
    }
    std::string add_interface(const Words& words) {
        need(words, 2);
        need_name(words[1]);
        if (component_.interface(words[1])) fail("there are two interfaces " + words[1]);
        const std::string& end = words.size() > 3 ? words[3] : std::string{"end"};
        const bool start = end == "start" || end == "master" || end == "source";
        std::string type = words[2];
        if (type == "avalon_slave" || type == "avalon_master") type = "avalon";
        component_.interfaces.push_back(
            {words[1], type, start || words[2] == "avalon_master", {}, {}});
        return {};
    }
    Interface& interface(const std::string& name) {
        for (Interface& i : component_.interfaces)
            if (i.name == name) return i;
        fail("there is no interface " + name);
    }
    // set_interface_property NAME PROPERTY VALUE ?PROPERTY VALUE ...?
    std::string set_interface_property(const Words& words) {
        need(words, 3);
        for (std::size_t n = 2; n + 1 < words.size(); n += 2) {
            const bool is_old = words[n] == "ASSOCIATED_CLOCK";  // before Quartus 10
            interface(words[1]).properties[is_old ? "associatedClock" : words[n]] = words[n + 1];
        }
        return {};
    }
    std::string get_interface_property(const Words& words) {
        need(words, 2);
        return interface(words[1]).property(words[2]);
    }
    // add_interface_port INTERFACE PORT ROLE DIRECTION WIDTH
    std::string add_interface_port(const Words& words) {
        need(words, 3);
        const std::string direction = words.size() > 4 ? lower(words[4]) : "input";
        need_name(words[2]);
        widths_[words[2]] = words.size() > 5 ? words[5] : "1";
        interface(words[1]).ports.push_back({words[2], words[3],
                                             direction == "output"  ? Port::Direction::OUTPUT
                                             : direction == "bidir" ? Port::Direction::BIDIR
                                                                    : Port::Direction::INPUT,
                                             1, false});
        return {};
    }
    std::string set_port_property(const Words& words) {
        need(words, 3);
        if (words[2] == "WIDTH" || words[2] == "WIDTH_EXPR") widths_[words[1]] = words[3];
        if (words[2] == "VHDL_TYPE" && words[3] == "STD_LOGIC_VECTOR") vectors_.insert(words[1]);
        if (words[2] == "TERMINATION" && (lower(words[3]) == "true" || words[3] == "1"))
            terminated_.insert(words[1]);
        return {};
    }
    std::string set_module_assignment(const Words& words) {
        need(words, 2);
        component_.assignments[words[1]] = words[2];
        return {};
    }
    std::string get_module_assignment(const Words& words) {
        need(words, 1);
        return component_.assignments[words[1]];
    }
    std::string send_message(const Words& words) {
        need(words, 2);
        if (lower(words[1]) == "error")
            fail_of_file(instance_ + " does not take its parameters: " + words[2]);
        return {};
    }

    // ---- What follows from them ----

    struct Fileset {
        std::string name, kind, callback, top;
        std::vector<ComponentFile> files;
    };

    void add_files() {
        component_.module = property_of_module("TOP_LEVEL_HDL_MODULE");
        component_.files = old_files_;
        for (Fileset& f : filesets_) {
            if (f.kind != "QUARTUS_SYNTH") continue;
            if (!f.callback.empty()) {
                callback_fileset_ = &f;
                guarded([&] { tcl_.run(f.callback + " {" + instance_ + "}"); });
                callback_fileset_ = nullptr;
            }
            component_.module = f.top.empty() ? property_of_module("NAME") : f.top;
            component_.files = f.files;
            return;
        }
    }

    // A number, a parameter, or what is computed of them.
    void set_width(Port& port) {
        const std::string& text = widths_[port.name];
        std::string expression;
        for (std::size_t i = 0; i < text.size();) {
            std::size_t end = i;
            while (end < text.size() &&
                   (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_'))
                ++end;
            const std::string word = text.substr(i, std::max<std::size_t>(end - i, 1));
            const auto found = std::find_if(  // whatever its case
                parameters_.begin(), parameters_.end(),
                [name = lower(word)](const auto& p) { return lower(p.first) == name; });
            expression += found == parameters_.end() ? word : found->second.value;
            i += word.size();
        }
        const auto width = number(expression);
        if (!width || *width < 0 || *width > static_cast<long>(WIDEST_PORT))
            fail_of_file(fmt::format(
                "the width of port {} is `{}`, expected a number of 1 to {}, or parameters",
                port.name, text, WIDEST_PORT));
        port.width = static_cast<unsigned>(*width);
        port.is_vector = port.width != 1 || vectors_.count(port.name) > 0 || text != "1";
        if (terminated_.count(port.name)) port.width = 0;
    }
    std::optional<long> number(const std::string& expression) {
        try {
            return std::stol(tcl_.run("expr int(" + expression + ")"));
        } catch (const std::exception&) {
            return {};
        }
    }

    // What a person or the vendor's tool reads, and nothing here.
    static constexpr const char* SILENT[] = {"package",
                                             "add_display_item",
                                             "set_display_item_property",
                                             "add_documentation_link",
                                             "set_interface_assignment",
                                             "set_parameter_update_callback",
                                             "set_interface_upgrade_map",
                                             "get_current_fileset_property",
                                             "add_sv_interface",
                                             "set_sv_interface_property",
                                             "set_qip_strings",
                                             "declare_parameter_upgrade_callback",
                                             "set_module_upgrade"};

    const std::vector<std::pair<const char*, Method>> METHODS{
        {"source", &ComponentReader::source},
        {"file", &ComponentReader::of_file},
        {"set_module_property", &ComponentReader::set_module_property},
        {"get_module_property", &ComponentReader::get_module_property},
        {"add_parameter", &ComponentReader::add_parameter},
        {"set_parameter_property", &ComponentReader::set_parameter_property},
        {"get_parameter_property", &ComponentReader::get_parameter_property},
        {"get_parameter_value", &ComponentReader::get_parameter_value},
        {"set_parameter_value", &ComponentReader::set_parameter_value},
        {"get_parameters", &ComponentReader::get_parameters},
        {"add_fileset", &ComponentReader::add_fileset},
        {"set_fileset_property", &ComponentReader::set_fileset_property},
        {"add_fileset_file", &ComponentReader::add_fileset_file},
        {"add_file", &ComponentReader::add_file},
        {"add_interface", &ComponentReader::add_interface},
        {"set_interface_property", &ComponentReader::set_interface_property},
        {"get_interface_property", &ComponentReader::get_interface_property},
        {"add_interface_port", &ComponentReader::add_interface_port},
        {"set_port_property", &ComponentReader::set_port_property},
        {"set_module_assignment", &ComponentReader::set_module_assignment},
        {"get_module_assignment", &ComponentReader::get_module_assignment},
        {"send_message", &ComponentReader::send_message}};

    SafeTcl tcl_;
    const std::string& text_;
    const Parameters& given_;  // the instance's
    const std::string instance_;
    std::string script_;  // that is executed, and the line in it
    unsigned line_ = 1, sourced_ = 0;
    Component component_;
    std::map<std::string, std::string> module_properties_;
    std::map<std::string, Parameter> parameters_;
    std::map<std::string, std::string> widths_;  // of ports
    std::set<std::string> vectors_, terminated_;
    std::list<Fileset> filesets_;  // their callbacks may add others
    Fileset* callback_fileset_ = nullptr;
    std::vector<ComponentFile> old_files_;
};

}  // namespace

std::string Interface::property(const std::string& property_name,
                                const std::string& otherwise) const {
    const auto found = properties.find(property_name);
    return found == properties.end() || found->second.empty() ? otherwise : found->second;
}

unsigned Interface::number(const std::string& property_name, unsigned otherwise) const {
    const std::string text = property(property_name);
    return text.empty() ? otherwise : static_cast<unsigned>(std::strtoul(text.c_str(), nullptr, 0));
}

const Port* Interface::port(const std::string& role) const {
    for (const Port& p : ports)
        if (p.role == role && p.width > 0) return &p;
    return nullptr;
}

const Interface* Component::interface(const std::string& name) const {
    for (const Interface& i : interfaces)
        if (i.name == name) return &i;
    return nullptr;
}

Component component_in(const std::string& text, const fs::path& file, const Parameters& parameters,
                       const std::string& instance) {
    return ComponentReader{text, file, parameters, instance}.run();
}

Component read_component(const fs::path& hw_tcl, const Parameters& parameters,
                         const std::string& instance) {
    return component_in(text_of(hw_tcl), hw_tcl, parameters, instance);
}

}  // namespace sim::project::qsys
