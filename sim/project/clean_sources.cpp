#include "sim/project/clean_sources.h"

#include <set>

#include <fmt/format.h>

#include "sim/project/generated.h"
#include "sim/project/init_checks.h"
#include "sim/project/tools.h"
#include "sim/text/lower.h"
#include "sim/verilog/gates.h"
#include "sim/verilog/included_files.h"
#include "sim/verilog/normalise.h"
#include "sim/verilog/part_drivers.h"
#include "sim/verilog/pulled_inputs.h"
#include "sim/verilog/read_outputs.h"
#include "sim/verilog/source.h"
#include "sim/verilog/synthesised.h"
#include "sim/vhdl/vhdl.h"
#include "sim/vhdl/vhdl_library.h"
#include "sim/vhdl/vhdl_ports.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

void add_modules(const std::string& text, Modules& modules, bool in_library = false) {
    for (ModuleText& module : scan(text).modules) {
        module.in_library = in_library;
        modules.emplace(module.name, std::move(module));
    }
}
std::string synthesised(const SourceFile& file, const SourceRequest& from) {
    return with_ports_of_entities(as_synthesised(file.whole_text(), from.project.macros),
                                  from.entities);
}
// The models that the modules instance.
void add_models(Modules& modules) {
    std::set<std::string> wanted;
    for (const auto& [name, module] : modules)
        wanted.insert(module.wants.begin(), module.wants.end());
    for (const std::string& name : wanted)
        if (const auto model = model_of(name); model && !modules.count(name))
            add_modules(text_of(*model), modules);
}

// The Verilog of each entity that is not only instanced by VHDL.
std::vector<std::string> translate_vhdl(const SourceRequest& from, const Modules& modules,
                                        std::vector<InitFile>& init_files) {
    const Project& project = from.project;
    if (project.entities.empty()) return {};
    const fs::path ip = data_folder() / "rtl" / "ip";
    Modules models;
    const auto in_verilog = [&](const std::string& component) -> const ModuleText* {
        if (const auto found = modules.find(component); found != modules.end())
            return &found->second;
        for (const auto& [name, module] : modules)
            if (lower(name) == lower(component)) return &module;
        const std::string model = lower(component) == "tri" ? "TRI" : lower(component);
        if (!from.is_model(model)) return nullptr;
        add_modules(text_of(*model_of(model)), models);
        return &models.at(model);
    };
    std::vector<VhdlRoot> roots;
    for (const GenericEntity& entity : from.entities)
        for (std::size_t n = 0; n < entity.sets.size(); ++n)
            roots.push_back({entity.name, entity.module(n), entity.options(n)});
    std::set<fs::path> needed;
    for (const SourceFile& file : project.sources) needed.insert(file.path);
    const auto words = [&, folders = init_folders(project)](
                           const std::string& file, const std::string& place, unsigned width) {
        const fs::path of = project.folder / place.substr(0, place.rfind(':'));
        if (!needed.count(of.lexically_normal())) return std::vector<std::string>{};
        init_files.push_back({file, place, {}});
        return initial_words(init_files.back(), folders, width);
    };
    const std::vector<std::string> texts =
        verilog_of({project.folder, project.vhdl, roots, needed, from.folder / "vhdl",
                    vhdl_libraries(ip, read_open_inputs(ip / "defaults.tsv")),
                    project.vhdl_libraries, in_verilog, words},
                   from.limit);
    std::vector<std::string> all;
    auto text = texts.begin();
    for (const GenericEntity& entity : from.entities) {
        const auto end = text + static_cast<std::ptrdiff_t>(entity.sets.size());
        const std::vector<std::string> modules_of_sets{text, end};
        all.push_back(entity.is_set ? entity.wrapper(modules_of_sets) : "");
        for (; text != end; ++text) all.back() += entity.in_order(*text);
    }
    return all;
}

// In `to` copies of included files that Verilator is to read otherwise, by the names that the
// directives have: text(file, name) is what it reads.
template <class Text>
void copy_included(const std::vector<IncludedFile>& files, const Project& project,
                   const fs::path& to, Text text) {
    std::set<fs::path> copies;
    for (const IncludedFile& file : files) {
        const fs::path copy = (to / file.name).lexically_normal();
        const bool is_below =
            !copy.lexically_relative(to).empty() && *copy.lexically_relative(to).begin() != "..";
        if (!is_below) continue;
        const std::string name = file.path.lexically_relative(project.folder).string();
        const std::string read = text(file, name);
        if (read == file.text) continue;
        fs::create_directories(copy.parent_path());
        write_if_new(copy, fmt::format("`line 1 \"{}\" 0\n{}", without_blanks(name), read));
        copies.insert(copy);
    }
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator{to, error})
        if (entry.is_regular_file() && !copies.count(entry.path())) fs::remove(entry.path(), error);
}

bool has_modules(const IncludedFile& file) { return !scan(file.synthesised).modules.empty(); }

// The modules below the top, and all where that is an entity.
std::set<std::string> modules_of_design(const Modules& modules, const std::string& top) {
    std::set<std::string> names;
    std::vector<std::string> open{top};
    if (!modules.count(top))
        for (const auto& [name, module] : modules) open.push_back(name);
    while (!open.empty()) {
        const auto module = modules.find(open.back());
        open.pop_back();
        if (module == modules.end() || !names.insert(module->first).second) continue;
        open.insert(open.end(), module->second.wants.begin(), module->second.wants.end());
    }
    return names;
}

// Whether Verilog may set parameters of a module: NAME #(...), or a defparam, of whatever.
bool sets_parameters(const SourceFile& file, const std::string& module) {
    const std::string text = file.whole_text();
    const Tokens tokens = tokens_of(text);
    for (std::size_t i = 0; i + 1 < tokens.all.size(); ++i)
        if (tokens.all[i].is("defparam") || (tokens.all[i].is(module) && tokens.all[i + 1].is("#")))
            return true;
    return false;
}

}  // namespace

std::vector<GenericEntity> generic_entities(const Project& project) {
    std::vector<GenericEntity> entities;
    for (const std::string& name : project.entities) {
        GenericEntity entity{{}, name, {}, false, {{}}};
        for (const fs::path& file : project.vhdl)
            if (const auto head = entity_in(text_of(file), name)) {
                entity.head = *head;
                entity.file = file.lexically_relative(project.folder).string();
            }
        for (const SourceFile& file : project.sources)
            entity.is_set =
                entity.is_set || (file.language != SourceFile::Language::VHDL &&
                                  !entity.head.generics.empty() && sets_parameters(file, name));
        for (const auto& [parameter, value] : project.parameters)
            if (name == project.top && is_generic(entity.head, parameter)) entity.is_set = true;
        if (entity.is_set) entity.sets.clear();
        entities.push_back(std::move(entity));
    }
    return entities;
}

CleanSources clean_sources(const SourceRequest& from) {
    const Project& project = from.project;
    CleanSources clean;
    unsigned number = 0;
    Modules modules;
    std::vector<std::string> texts;
    for (const SourceFile& file : project.sources)
        if (file.language != SourceFile::Language::VHDL) {
            texts.push_back(synthesised(file, from));
            add_modules(texts.back(), modules, !file.text.empty() || !file.library.empty());
        }
    const std::vector<IncludedFile> included =
        included_files(texts, project.includes, project.macros);
    for (const IncludedFile& file : included) {
        clean.included += file.text;
        if (has_modules(file)) add_modules(file.synthesised, modules, false);
    }
    const std::vector<std::string> vhdl = translate_vhdl(from, modules, clean.init_files);
    for (const std::string& text : vhdl)
        for (ModuleText& module : scan(text).modules) modules.emplace(module.name, module);
    OpenInputs open_inputs = read_open_inputs(data_folder() / "rtl/ip/defaults.tsv");
    for (const auto& [name, own] : modules) open_inputs.erase(name);  // not the model of that name
    std::vector<Tokens> tokens;
    for (const std::string& text : texts) tokens.push_back(tokens_of(text));
    for (const Tokens& file : tokens)
        for (auto& input : pulled_up_inputs(file.all)) open_inputs.insert(std::move(input));
    const std::set<std::string> in_design = modules_of_design(modules, project.top);
    add_models(modules);
    find_read_outputs(tokens, modules);
    const PinPorts pins = pin_ports(tokens, modules, project.top);
    for (const SourceFile& file : project.sources) {
        const std::string name = file.path.lexically_relative(project.folder).string();
        if (file.language == SourceFile::Language::VHDL) continue;
        const bool system_verilog = file.language == SourceFile::Language::SYSTEM_VERILOG;
        const auto fits = from.inout_fits.find(name);
        Normalised normalised =
            normalise(with_enables(gates_as_assignments(synthesised(file, from), modules), pins),
                      name, system_verilog, open_inputs, modules,
                      fits == from.inout_fits.end() ? std::vector<InoutFit>{} : fits->second, pins);
        clean.changes.insert(clean.changes.end(), normalised.changes.begin(),
                             normalised.changes.end());
        for (const InitName& init : normalised.init_names)
            if (in_design.count(init.module))
                clean.init_files.push_back(
                    {init.name, fmt::format("{}:{}", name, init.line), init.reader});
        for (TextChecks::OfModule& one : normalised.checks.of_modules)
            if (in_design.count(one.module))
                (one.is_error ? normalised.checks.errors : normalised.checks.warnings)
                    .push_back(std::move(one.message));
        clean.checks[name] = std::move(normalised.checks);
        const fs::path to = fmt::format("source/{:03}{}", number++, system_verilog ? ".sv" : ".v");
        write_if_new(from.folder / to,
                     fmt::format("`line 1 \"{}\" 0\n{}{}", without_blanks(name),
                                 // As Quartus does in SystemVerilog.
                                 system_verilog ? "/*verilator lint_off PROCASSWIRE*/" : "",
                                 normalised.text));
        clean.files.push_back(to);
    }
    copy_included(
        included, project, from.folder / "included",
        [&](const IncludedFile& file, const std::string& name) {
            if (!has_modules(file)) return file.synthesised;
            const bool system_verilog = file.path.extension() == ".sv";
            return normalise(with_enables(gates_as_assignments(file.synthesised, modules), pins),
                             name, system_verilog, open_inputs, modules, {}, pins)
                .text;
        });
    for (std::size_t n = 0; n < vhdl.size(); ++n) {
        const fs::path to = fmt::format("source/vhdl{}.v", n);
        const std::string name = project.entities[n] + " in Verilog";
        write_if_new(from.folder / to, normalise(vhdl[n], name, false, open_inputs, modules).text);
        clean.files.push_back(to);
    }
    return clean;
}

}  // namespace sim::project
