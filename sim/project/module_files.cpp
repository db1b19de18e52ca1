#include "sim/project/module_files.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/project/processor_primitives.h"
#include "sim/project/settings.h"
#include "sim/text/lower.h"
#include "sim/verilog/nearest.h"
#include "sim/verilog/synthesised.h"
#include "sim/verilog/unsupported.h"
#include "sim/vhdl/vhdl_source.h"

namespace sim::project {

namespace fs = std::filesystem;

using Language = SourceFile::Language;

std::optional<Language> language_of(const fs::path& path) {
    const std::string ending = lower(path.extension().string());
    if (ending == ".v" || ending == ".vo" || ending == ".vt") return Language::VERILOG;
    if (ending == ".sv") return Language::SYSTEM_VERILOG;
    if (ending == ".vhd" || ending == ".vhdl") return Language::VHDL;
    return {};
}

std::string ModuleFiles::place(const fs::path& file) const {
    return fs::absolute(file).lexically_normal().lexically_relative(folder_).string();
}

void ModuleFiles::add(const SourceFile& added) {
    const fs::path& file = added.path;
    if (!known_.insert(file).second) return;
    if (is_simulation_library(file)) {
        notes_.push_back(
            fmt::format("{} is passed over: a library of Quartus for simulators, of which "
                        "there are models here",
                        place(file)));
        return;
    }
    Source source{added, {}};
    std::string text = added.whole_text();
    if (const auto header = without_pins(file, text)) source.file.text = text = *header;
    if (added.language != Language::VHDL) {
        source.text = scan(as_synthesised(text, macros_));
    } else {
        source.text = scan_vhdl(text);
    }
    if (project::is_encrypted(file, text)) encrypted_.insert(file);
    sources_.push_back(std::move(source));
    const std::size_t n = sources_.size() - 1;
    for (const ModuleText& module : sources_[n].text.modules) {
        const Definition& first =
            modules_.emplace(module.name, Definition{n, &module}).first->second;
        if (first.source == n) continue;
        auto& all = rivals_[module.name];
        if (all.empty()) all.push_back(first);
        if (all.back().source != n) all.push_back({n, &module});
    }
}

const ModuleFiles::Definition* ModuleFiles::in_any_case(const std::string& name) const {
    for (const auto& [module, d] : modules_)
        if (lower(module) == lower(name)) return &d;
    return nullptr;
}

const ModuleFiles::Definition* ModuleFiles::definition(const std::string& name, bool from_vhdl) {
    if (const auto i = modules_.find(name); i != modules_.end()) return &i->second;
    if (const Definition* d = in_any_case(name); d && (from_vhdl || is_vhdl(*d))) return d;
    for (const fs::path& file : finder_.with_stem(name))
        if (const auto language = language_of(file); language && !known_.count(file)) {
            const bool system = is_system_verilog_ && *language == SourceFile::Language::VERILOG;
            add({file, system ? SourceFile::Language::SYSTEM_VERILOG : *language, false, {}});
            if (const auto i = modules_.find(name); i != modules_.end()) {
                notes_.push_back(
                    fmt::format("12125: {} is not listed; it defines {}", place(file), name));
                return &i->second;
            }
        }
    return nullptr;
}

void ModuleFiles::choose_nearest(const std::string& module, const fs::path& user) {
    const auto rivals = rivals_.find(module);
    if (rivals == rivals_.end()) return;
    std::vector<fs::path> files;
    for (const Definition& d : rivals->second) files.push_back(sources_[d.source].file.path);
    const std::size_t taken = nearest(files, user, module);
    modules_[module] = rivals->second[taken];
    std::string others;
    for (std::size_t n = 0; n < files.size(); ++n)
        if (n != taken) others += (others.empty() ? "" : ", ") + place(files[n]);
    notes_.push_back(fmt::format("{} files define {}: {} is taken, not {}", files.size(), module,
                                 place(files[taken]), others));
}

bool ModuleFiles::is_passed_over(const Source& source) const {
    const auto& modules = source.text.modules;
    return !modules.empty() &&
           std::all_of(modules.begin(), modules.end(), [&](const ModuleText& module) {
               return &sources_[modules_.at(module.name).source] != &source;
           });
}

std::vector<std::size_t> ModuleFiles::in_order(std::set<std::size_t> sources) const {
    const auto waits = [&](std::size_t n) {
        const auto& modules = sources_[n].text.modules;
        return std::any_of(modules.begin(), modules.end(), [&](const ModuleText& module) {
            const std::size_t taken = modules_.at(module.name).source;
            return taken != n && sources.count(taken);
        });
    };
    std::vector<std::size_t> order;
    while (!sources.empty()) {
        auto next = std::find_if_not(sources.begin(), sources.end(), waits);
        if (next == sources.end()) next = sources.begin();
        order.push_back(*next);
        sources.erase(next);
    }
    return order;
}

}  // namespace sim::project
