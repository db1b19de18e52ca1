#include "sim/project/project.h"

#include <algorithm>
#include <deque>
#include <set>

#include <fmt/format.h>

#include "sim/project/board_pins.h"
#include "sim/project/file_finder.h"
#include "sim/project/nearest.h"
#include "sim/project/source.h"
#include "sim/project/unsupported.h"
#include "sim/project/vhdl_source.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

using Language = SourceFile::Language;

std::optional<Language> language_of(const fs::path& path) {
    const std::string ending = lower(path.extension().string());
    if (ending == ".v" || ending == ".vo" || ending == ".vt") return Language::VERILOG;
    if (ending == ".sv") return Language::SYSTEM_VERILOG;
    if (ending == ".vhd" || ending == ".vhdl") return Language::VHDL;
    return {};
}

class ProjectReader {
public:
    explicit ProjectReader(const Request& request)
        : request_{request},
          settings_{settings_at(request.place)},
          folder_{fs::absolute(settings_.empty() ? request.place / "x" : settings_)
                      .lexically_normal()
                      .parent_path()},
          finder_{folder_} {
        project_.folder = folder_;
        project_.settings = settings_;
        project_.top = request.top;
        project_.macros = request.macros;
    }

    Project run() {
        if (!settings_.empty()) {
            for (const Assignment& a : read_settings(settings_)) take(a);
            if (project_.top.empty()) project_.top = settings_.stem().string();
        }
        if (other_device_) project_.pins.clear();
        is_folder_alone_ = sources_.empty();
        if (is_folder_alone_) {
            for (const fs::path& file : finder_.files())
                if (const auto language = language_of(file)) add(file, *language, true);
            if (sources_.empty()) refuse_files();
            if (sources_.empty())
                throw ProjectError{folder_.string() + ": no Verilog or VHDL files found here"};
        }
        choose_top();
        take_what_it_needs();
        return std::move(project_);
    }

private:
    struct Source {
        SourceFile file;
        SourceText text;
    };
    struct Definition {
        std::size_t source;
        const ModuleText* module;
    };

    void note(std::string text) { project_.notes.push_back(std::move(text)); }
    std::string place(const fs::path& file) const {
        return fs::absolute(file).lexically_normal().lexically_relative(folder_).string();
    }

    void take(const Assignment& a) {
        const std::string& name = a.name;
        if (name == "LOCATION") {
            project_.pins[a.to] = a.value;
        } else if (name == "TOP_LEVEL_ENTITY") {
            if (request_.top.empty()) project_.top = a.value;
        } else if (name == "VERILOG_MACRO") {
            project_.macros.push_back(a.value);
        } else if (name == "PARAMETER") {
            project_.parameters[a.to] = {verilog_value(a.value),
                                         fmt::format("{}:{}", place(a.file), a.line)};
        } else if (name == "INSTANCE_PARAMETER") {
            note(fmt::format("{}:{}: set_parameter of an instance is passed over", place(a.file),
                             a.line));
        } else if (name == "SEARCH_PATH") {
            std::string path = a.value;
            std::replace(path.begin(), path.end(), '\\', '/');
            project_.includes.push_back((folder_ / path).lexically_normal());
        } else if (name == "DEVICE") {
            if (lower(a.value).compare(0, 12, "5csema5f31c6") == 0) return;
            note(fmt::format(
                "DEVICE is {}, not the DE1-SoC's 5CSEMA5F31C6: ports go by their names", a.value));
            other_device_ = true;
        } else if (name == "VERILOG_FILE" || name == "SYSTEMVERILOG_FILE" || name == "VHDL_FILE" ||
                   name == "SOURCE_FILE") {
            take_source(a);
        } else if (name == "QIP_FILE") {
            if (const auto file = resolve(a))
                for (const Assignment& inner : read_settings(*file)) take(inner);
        } else if (const auto why = unsupported_file(a.value);
                   why && name.size() > 5 && name.compare(name.size() - 5, 5, "_FILE") == 0) {
            unsupported_.push_back(
                fmt::format("{}:{}: {}: {}", place(a.file), a.line, a.value, *why));
        }
    }

    std::optional<fs::path> resolve(const Assignment& a) {
        const auto found =
            finder_.find(a.value, a.in_qip_folder ? fs::absolute(a.file).parent_path() : folder_);
        if (!found) {
            note(fmt::format("{}:{}: {} is not there", place(a.file), a.line, a.value));
            return {};
        }
        if (!found->exact)
            note(fmt::format("{}:{}: {} is taken from {}", place(a.file), a.line, a.value,
                             place(found->path)));
        return found->path;
    }

    void take_source(const Assignment& a) {
        const auto file = resolve(a);
        if (!file) return;
        const auto by_ending = language_of(*file);
        Language language = by_ending.value_or(Language::VERILOG);
        if (a.name == "SYSTEMVERILOG_FILE") language = Language::SYSTEM_VERILOG;
        if (a.name == "VHDL_FILE") language = Language::VHDL;
        add(*file, language, true);
    }

    void add(const fs::path& file, Language language, bool listed) {
        if (!known_.insert(file).second) return;
        if (is_simulation_library(file)) {
            note(
                fmt::format("{} is passed over: a library of Quartus for simulators, of which "
                            "there are models here",
                            place(file)));
            return;
        }
        Source source{{file, language, listed}, {}};
        if (language != Language::VHDL) {
            const std::string text = text_of(file);
            source.text = scan(text);
            if (is_encrypted(file, text)) encrypted_.insert(file);
        } else {
            source.text = scan_vhdl(text_of(file));
        }
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

    // Quartus is told which file it is; in a folder the nearest to the one that wants the module.
    void take_nearest(const std::string& module, const fs::path& user) {
        const auto rivals = rivals_.find(module);
        if (!is_folder_alone_ || rivals == rivals_.end()) return;
        std::vector<fs::path> files;
        for (const Definition& d : rivals->second) files.push_back(sources_[d.source].file.path);
        const std::size_t taken = nearest(files, user);
        modules_[module] = rivals->second[taken];
        std::string others;
        for (std::size_t n = 0; n < files.size(); ++n)
            if (n != taken) others += (others.empty() ? "" : ", ") + place(files[n]);
        note(fmt::format("{} files define {}: {} is taken, not {}", files.size(), module,
                         place(files[taken]), others));
    }

    // Files in an order in which the first of several modules of one name is the one to take.
    std::vector<std::size_t> in_order(std::set<std::size_t> files) const {
        const auto waits = [&](std::size_t n) {
            const auto& modules = sources_[n].text.modules;
            return std::any_of(modules.begin(), modules.end(), [&](const ModuleText& module) {
                const std::size_t taken = modules_.at(module.name).source;
                return taken != n && files.count(taken);
            });
        };
        std::vector<std::size_t> order;
        while (!files.empty()) {
            auto next = std::find_if_not(files.begin(), files.end(), waits);
            if (next == files.end()) next = files.begin();
            order.push_back(*next);
            files.erase(next);
        }
        return order;
    }

    // GHDL would take the last one that it reads.
    bool has_only_rivals(const Source& source) const {
        const auto& modules = source.text.modules;
        return is_folder_alone_ && !modules.empty() &&
               std::all_of(modules.begin(), modules.end(), [&](const ModuleText& module) {
                   return &sources_[modules_.at(module.name).source] != &source;
               });
    }

    bool is_vhdl(const Definition& d) const {
        return sources_[d.source].file.language == Language::VHDL;
    }

    // As VHDL has it, which has no case.
    const Definition* in_any_case(const std::string& name) const {
        for (const auto& [module, d] : modules_)
            if (lower(module) == lower(name)) return &d;
        return nullptr;
    }

    // The definition of a module, also by a file of its name that the project does not list.
    const Definition* definition(const std::string& name, bool from_vhdl = false) {
        if (const auto i = modules_.find(name); i != modules_.end()) return &i->second;
        if (const Definition* d = in_any_case(name); d && (from_vhdl || is_vhdl(*d))) return d;
        for (const fs::path& file : finder_.with_stem(name))
            if (const auto language = language_of(file); language && !known_.count(file)) {
                add(file, *language, false);
                if (const auto i = modules_.find(name); i != modules_.end()) {
                    note(fmt::format("{} is not listed; it defines {}", place(file), name));
                    return &i->second;
                }
            }
        return nullptr;
    }

    // ProjectError: there is a file that cannot be simulated, for this module or at all.
    void refuse_files(const std::string& module = {}) const {
        for (const fs::path& file : finder_.files())
            if (const auto why = unsupported_file(file);
                why && (module.empty() || lower(file.stem().string()) == lower(module)))
                throw ProjectError{fmt::format("{}: {}", place(file), *why)};
    }
    // ProjectError: why there is no such module, if that is known.
    void refuse_missing() const {
        for (const auto& [module, by] : missing_)
            if (const auto why = unsupported_module(module))
                throw ProjectError{fmt::format("{}: module {}, which {} wants: {}",
                                               folder_.string(), module, by, *why)};
        for (const auto& [module, by] : missing_) refuse_files(module);
        if (missing_.empty()) return;
        if (!unsupported_.empty()) throw ProjectError{unsupported_.front()};
        if (!encrypted_.empty()) throw ProjectError{place(*encrypted_.begin()) + ": " + ENCRYPTED};
    }

    void choose_top() {
        if (!project_.top.empty() && definition(project_.top)) return;
        if (!project_.top.empty()) refuse_files(project_.top);
        if (!request_.top.empty())
            throw ProjectError{fmt::format("--top {}: no file defines that module", request_.top)};
        std::set<std::string> instanced;  // but by test benches, which have no ports
        for (const auto& [name, d] : modules_)
            if (!d.module->ports.empty())
                instanced.insert(d.module->wants.begin(), d.module->wants.end());
        std::vector<std::pair<std::size_t, std::string>> candidates;
        for (const auto& [name, d] : modules_) {
            if (instanced.count(name) || d.module->is_package) continue;
            const auto& ports = d.module->ports;
            const auto count = std::count_if(ports.begin(), ports.end(), [](const auto& port) {
                return board_signal(port).has_value();
            });
            if (count > 0) candidates.emplace_back(static_cast<std::size_t>(count), name);
        }
        std::sort(candidates.rbegin(), candidates.rend());
        if (candidates.empty() && !unsupported_.empty()) throw ProjectError{unsupported_.front()};
        if (candidates.empty())
            throw ProjectError{fmt::format(
                "{}: {}; no module has the board's pins as ports (CLOCK_50, KEY, VGA_R ...)",
                (settings_.empty() ? folder_ : settings_).string(),
                project_.top.empty() ? "no top module is named"
                                     : "the top module " + project_.top + " is not there")};
        std::string others;
        for (std::size_t i = 1; i < candidates.size() && i < 6; ++i)
            others += (others.empty() ? "; also possible: " : ", ") + candidates[i].second;
        if (candidates.size() > 1 && candidates[0].first == candidates[1].first)
            throw ProjectError{
                fmt::format("{}: two top modules are possible, choose by --top: {}{}",
                            folder_.string(), candidates[0].second, others)};
        note(fmt::format("the top module is taken to be {}, which has {} of the board's pins{}",
                         candidates[0].second, candidates[0].first, others));
        project_.top = candidates[0].second;
    }

    void take_what_it_needs() {
        std::set<std::string> seen;
        std::set<std::size_t> packages, others;
        std::deque<std::pair<std::string, std::string>> open{{project_.top, ""}};
        while (!open.empty()) {
            const auto [name, by] = open.front();
            open.pop_front();
            if (!seen.insert(name).second) continue;
            const Definition* user = by.empty() ? nullptr : definition(by);
            const bool from_vhdl = user && is_vhdl(*user);
            if (request_.is_model(from_vhdl ? lower(name) : name) && !modules_.count(name))
                continue;
            const Definition* d = definition(name, from_vhdl);
            if (!d) {
                if (!by.empty()) missing_.emplace_back(name, by);
                continue;
            }
            // The top is wanted by nobody: the nearest to the folder itself.
            take_nearest(d->module->name, user ? sources_[user->source].file.path : folder_ / "");
            if (is_vhdl(*d) && !d->module->is_package && !from_vhdl)
                project_.entities.push_back(name);
            (d->module->is_package ? packages : others).insert(d->source);
            const SourceText& text = sources_[d->source].text;
            for (const std::string& package : text.packages) open.emplace_back(package, name);
            for (const std::string& wanted : d->module->wants) open.emplace_back(wanted, name);
        }
        for (const auto* group : {&packages, &others})
            for (const std::size_t n : in_order(*group))
                if (group == &packages || !packages.count(n))
                    project_.sources.push_back(sources_[n].file);
        for (const Source& source : sources_)
            if (source.file.language == Language::VHDL && !project_.entities.empty() &&
                !has_only_rivals(source))
                project_.vhdl.push_back(source.file.path);
        std::set<fs::path> folders{folder_};
        for (const SourceFile& source : project_.sources) folders.insert(source.path.parent_path());
        project_.includes.insert(project_.includes.end(), folders.begin(), folders.end());
        refuse_missing();
        for (const SourceFile& source : project_.sources)
            if (encrypted_.count(source.path))
                throw ProjectError{place(source.path) + ": " + ENCRYPTED};
        for (const std::string& line : unsupported_) note(line);
        if (!project_.entities.empty()) note("VHDL goes through GHDL, which is experimental");
    }

    const Request& request_;
    const fs::path settings_, folder_;
    const FileFinder finder_;
    Project project_;
    std::deque<Source> sources_;  // whose modules stay where they are
    std::set<fs::path> known_;
    std::map<std::string, Definition> modules_;
    std::map<std::string, std::vector<Definition>> rivals_;  // of one name, in several files
    std::vector<std::string> unsupported_;
    std::set<fs::path> encrypted_;
    std::vector<std::pair<std::string, std::string>> missing_;  // modules, with who wants them
    bool is_folder_alone_ = false;                              // no files are listed
    bool other_device_ = false;  // so its pins' locations mean other signals
};

}  // namespace

Project read_project(const Request& request) { return ProjectReader{request}.run(); }

}  // namespace sim::project
