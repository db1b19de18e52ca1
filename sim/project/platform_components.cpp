#include "sim/project/platform_components.h"

#include <algorithm>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "sim/project/qsys/port_roles.h"
#include "sim/project/qsys/sopcinfo.h"
#include "sim/project/settings.h"
#include "sim/project/tools.h"
#include "sim/text/lower.h"
#include "sim/text/printable.h"
#include "sim/verilog/top_parameters.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

std::set<std::string> ports_of(const qsys::Component& component) {
    std::set<std::string> ports;
    for (const qsys::Interface& i : component.interfaces)
        for (const qsys::Port& port : i.ports) ports.insert(port.name);
    return ports;
}

bool is_ours(const fs::path& hw_tcl) {
    return hw_tcl.parent_path() == data_folder() / "rtl/ip/qsys";
}

}  // namespace

void PlatformComponents::find_names() {
    static const std::regex NAME{R"(set_module_property\s+NAME\s+["{]?([A-Za-z0-9_]+))"};
    constexpr std::string_view ENDING = "_hw.tcl";
    by_name_.emplace();
    std::vector<fs::path> candidates = files_.finder().files();
    // A component that another folder has is found on its author's machine by an option of Platform
    // Designer's; its Verilog is often among the project's files.
    std::set<fs::path> folders;
    for (std::size_t n = 0; n < files_.size(); ++n)
        folders.insert(files_.source(n).file.path.parent_path());
    std::error_code error;
    for (const fs::path& folder : folders)
        for (const auto& entry : fs::directory_iterator{folder, error})
            candidates.push_back(entry.path());
    // Or in a folder `ip`, which projects for several boards share.
    const fs::path shared = files_.folder().parent_path() / "ip";
    if (fs::is_directory(shared, error)) {
        const FileFinder beside{shared};
        candidates.insert(candidates.end(), beside.files().begin(), beside.files().end());
    }
    for (const fs::path& file : candidates) {
        const std::string name = lower(file.filename().string());
        if (name.size() < ENDING.size() || name.substr(name.size() - ENDING.size()) != ENDING)
            continue;
        const std::string text = text_of(file);
        if (std::smatch found; std::regex_search(text, found, NAME))
            by_name_->emplace(found[1], file);
    }
}

std::optional<fs::path> PlatformComponents::hw_tcl(const std::string& kind) {
    std::error_code error;
    const fs::path ours = data_folder() / "rtl/ip/qsys" / (kind + "_hw.tcl");
    const bool is_known = fs::is_regular_file(ours, error);
    // A project's own `multiplexer` is another one; a copy of the vendor's files is not.
    if (is_known && kind.rfind("alt", 0) == 0) return ours;
    if (!by_name_) find_names();
    if (const auto found = by_name_->find(kind); found != by_name_->end()) return found->second;
    const auto found = files_.finder().with_name(kind + "_hw.tcl");
    if (!found.empty()) return found.front();
    return is_known ? std::optional{ours} : std::nullopt;
}

const ModuleText* PlatformComponents::module_named(const std::string& kind) {
    const ModuleFiles::Definition* d = files_.definition(kind);
    return d && !d->module->is_package ? d->module : nullptr;
}

// Null: none has them.
const ModuleText* PlatformComponents::module_with_ports(const qsys::Component& component,
                                                        const qsys::Instance& instance) const {
    const std::set<std::string> wanted = ports_of(component);
    const ModuleText* found = nullptr;
    for (const auto& [name, d] : files_.modules()) {
        const auto& ports = d.module->ports;
        if (std::set<std::string>{ports.begin(), ports.end()} != wanted) continue;
        if (found)
            throw ProjectError{printable(fmt::format(
                "{}: {} is of the kind {}, which has no _hw.tcl; the modules {} and {} have its "
                "ports",
                component.file.filename().string(), instance.name, instance.kind, found->name,
                name))};
        found = d.module;
    }
    return found;
}

// The component editor leaves `new_component` as the module's name, and Platform Designer takes the
// module of the file marked TOP_LEVEL_FILE.
void PlatformComponents::find_module(qsys::Component& component) {
    const ModuleFiles::Source* top = nullptr;
    for (const qsys::ComponentFile& f : component.files) {
        const fs::path path = (component.file.parent_path() / f.path).lexically_normal();
        std::error_code error;
        const auto language = language_of(path);
        if (!language || !fs::is_regular_file(path, error)) continue;
        files_.add({path, *language, true, {}});
        for (std::size_t n = 0; f.has_top && n < files_.size(); ++n)
            if (files_.source(n).file.path == path) top = &files_.source(n);
    }
    if (!top || files_.definition(component.module, true)) return;
    const std::set<std::string> wanted = ports_of(component);
    for (const ModuleText& module : top->text.modules) {
        if (std::set<std::string>{module.ports.begin(), module.ports.end()} != wanted) continue;
        notes_.push_back(printable(fmt::format(
            "{} names the module {}, which its files do not have; module {} of {} is taken",
            files_.place(component.file), component.module, module.name,
            files_.place(top->file.path))));
        component.module = module.name;
        return;
    }
}

std::optional<qsys::Component> PlatformComponents::describe(const qsys::System& system,
                                                            const qsys::Instance& instance,
                                                            const qsys::Parameters& parameters) {
    if (const auto file = hw_tcl(instance.kind)) {
        auto component = qsys::read_component(*file, parameters, instance.name);
        if (!is_ours(*file)) find_module(component);
        return component;
    }
    const ModuleText* named = module_named(instance.kind);
    const auto note = [&](const fs::path& file, const ModuleText& module) {
        notes_.push_back(printable(fmt::format(
            "{}: {} is of the kind {}, which has no _hw.tcl: {} describes it, module {}",
            system.file.filename().string(), instance.name, instance.kind, files_.place(file),
            module.name)));
    };
    for (const fs::path& file : files_.finder().with_name(system.name + ".sopcinfo")) {
        auto component = qsys::component_in_sopcinfo(file, instance);
        if (!component) continue;
        const ModuleText* module = named ? named : module_with_ports(*component, instance);
        if (!module) continue;
        component->module = module->name;
        for (const std::string& p : module->parameters)
            if (const auto given = parameters.find(p); given != parameters.end())
                component->parameters[p] = verilog_value(given->second);
        note(file, *module);
        return component;
    }
    if (!named) return {};
    const fs::path& file = files_.source(files_.definition(instance.kind)->source).file.path;
    note(file, *named);
    return qsys::component_in(qsys::description_by_ports(*named, system, instance), file,
                              parameters, instance.name);
}

}  // namespace sim::project
