#include "sim/project/project.h"

#include <algorithm>
#include <charconv>
#include <deque>
#include <set>

#include <fmt/format.h>

#include "sim/project/module_files.h"
#include "sim/project/platform_components.h"
#include "sim/project/processor_primitives.h"
#include "sim/project/processor_systems.h"
#include "sim/project/qsys/subsystems.h"
#include "sim/project/tools.h"
#include "sim/project/top_module.h"
#include "sim/text/lower.h"
#include "sim/verilog/unsupported.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

using Language = SourceFile::Language;
using Definition = ModuleFiles::Definition;

class ProjectReader {
public:
    explicit ProjectReader(const Request& request)
        : request_{request},
          settings_{settings_at(request.place)},
          folder_{fs::absolute(settings_.empty() ? request.place / "x" : settings_)
                      .lexically_normal()
                      .parent_path()},
          files_{folder_, project_.macros, project_.notes},
          components_{files_, project_.notes} {
        project_.folder = folder_;
        project_.settings = settings_;
        project_.top = request.top;
        project_.macros = request.macros;
    }

    Project run() {
        if (!settings_.empty()) {
            const std::vector<Assignment> all = settings_of(settings_);
            for (const Assignment& a : all) {  // before the sources, which they change
                if (a.name == "VERILOG_MACRO") project_.macros.push_back(a.value);
                if (a.name == "VERILOG_INPUT_VERSION")
                    is_system_verilog_ = lower(a.value).compare(0, 13, "systemverilog") == 0;
            }
            if (is_system_verilog_) files_.take_verilog_as_system_verilog();
            for (const Assignment& a : all) apply(a);
            for (const fs::path& file : listed_systems_) add_system(file);
            if (project_.top.empty()) project_.top = settings_.stem().string();
        }
        choose_board();
        is_folder_alone_ = files_.size() == 0;
        if (is_folder_alone_) {
            for (const fs::path& file : files_.finder().files())
                if (const auto language = language_of(file);
                    language && !is_made_of_processor_system(file, files_.finder()))
                    files_.add({file, *language, true, {}});
            if (files_.size() == 0) refuse_files();
            if (files_.size() == 0)
                throw ProjectError{folder_.string() + ": no Verilog or VHDL files found here"};
        }
        choose_top();
        if (!is_folder_alone_) refuse_rivals();
        collect_what_it_needs();
        return std::move(project_);
    }

    const std::vector<std::string>& notes() const { return project_.notes; }

private:
    void note(std::string text) { project_.notes.push_back(std::move(text)); }
    std::string place_of(const Assignment& a) const {
        return fmt::format("{}:{}", files_.place(a.file), a.line);
    }

    std::vector<Assignment> settings_of(const fs::path& file) {
        Settings settings = read_settings(file);
        for (std::string& text : settings.notes) note(std::move(text));
        return std::move(settings.assignments);
    }

    unsigned rounds(const Assignment& a) const {
        unsigned count = 0;
        const char* const end = a.value.data() + a.value.size();
        const auto [after, error] = std::from_chars(a.value.data(), end, count);
        if (error != std::errc{} || after != end || !count)
            throw ProjectError{
                fmt::format("{}: {} is \"{}\", expected a number of rounds from 1 on", place_of(a),
                            a.name, a.value)};
        return count;
    }

    void apply(const Assignment& a) {
        const std::string& name = a.name;
        if (name == "LOCATION") {
            project_.pins[a.to] = a.value;
            project_.places_of_pins[a.to] = place_of(a);
        } else if (name == "HPS_LOCATION") {
            project_.processor_places[a.to.substr(a.to.rfind('|') + 1)] = a.value;
        } else if (name == "TOP_LEVEL_ENTITY") {
            if (request_.top.empty()) project_.top = a.value;
            place_of_top_ = place_of(a);
        } else if (name == "PARAMETER") {
            project_.parameters[a.to] = {verilog_value(a.value), place_of(a)};
        } else if (name == "INSTANCE_PARAMETER") {
            note(fmt::format("{}:{}: set_parameter of an instance is passed over",
                             files_.place(a.file), a.line));
        } else if (name == "SEARCH_PATH") {
            std::string path = a.value;
            std::replace(path.begin(), path.end(), '\\', '/');
            project_.includes.push_back((folder_ / path).lexically_normal());
        } else if (name == "VERILOG_CONSTANT_LOOP_LIMIT") {
            project_.loop_limits.constant = rounds(a);
        } else if (name == "VERILOG_NON_CONSTANT_LOOP_LIMIT") {
            project_.loop_limits.non_constant = rounds(a);
        } else if (name == "DEVICE") {
            device_ = a.value;
        } else if (name == "VERILOG_FILE" || name == "SYSTEMVERILOG_FILE" || name == "VHDL_FILE" ||
                   name == "SOURCE_FILE") {
            add_source(a);
        } else if (name == "SDC_FILE") {
            // A .qip's is of a core, not of the person, and asks the timing analyser what it does.
            if (const auto file = resolve(a); file && !a.in_qip_folder) check_timing(*file);
        } else if (name == "QSYS_FILE") {
            const auto file = resolve(a);
            if (file && has_processor(*file, files_.finder()))
                listed_systems_.push_back(*file);  // see definition()
        } else if (name == "QIP_FILE") {
            if (const auto system = system_of_qip(a.value, folder_, files_.finder());
                system && has_processor(*system, files_.finder()))
                listed_systems_.push_back(*system);
            else if (const auto file = resolve(a))
                for (const Assignment& inner : settings_of(*file)) apply(inner);
        } else if (const auto why = unsupported_file(a.value);
                   why && name.size() > 5 && name.compare(name.size() - 5, 5, "_FILE") == 0) {
            unsupported_.push_back(
                fmt::format("{}:{}: {}: {}", files_.place(a.file), a.line, a.value, *why));
        }
    }

    // For what is wrong in it.  What it sources computes with answers of the timing analyser.
    void check_timing(const fs::path& file) {
        try {
            settings_of(file);
        } catch (const ProjectError& error) {
            const std::string own = file.filename().string() + ":";
            if (std::string_view{error.what()}.substr(0, own.size()) == own) throw;
        }
    }

    std::optional<fs::path> resolve(const Assignment& a) {
        const auto found = files_.finder().find(
            a.value, a.in_qip_folder ? fs::absolute(a.file).parent_path() : folder_);
        // A black box beside the module that it stands for would be a second one.
        const bool is_other_black_box =
            found && !found->exact && lower(a.value).find("_bb.v") != std::string::npos;
        if (!found || is_other_black_box) {
            const unsigned number = a.name == "QIP_FILE"   ? 125092
                                    : a.name == "SDC_FILE" ? 332012
                                                           : 12019;
            note(fmt::format("{}:{}: {}: {} is not there", files_.place(a.file), a.line, number,
                             a.value));
            return {};
        }
        if (!found->exact)
            note(fmt::format("{}:{}: {} is taken from {}", files_.place(a.file), a.line, a.value,
                             files_.place(found->path)));
        return found->path;
    }

    void add_system(const fs::path& file) {
        if (!systems_.insert(file).second) return;
        const qsys::System system =
            qsys::with_subsystems(qsys::read_system(file), [&](const std::string& kind) {
                const auto found = files_.finder().with_name(kind + ".qsys");
                return found.empty() || components_.hw_tcl(kind) ? std::nullopt
                                                                 : std::optional{found.front()};
            });
        qsys::Generated made;
        try {
            made = qsys::generate(
                system, [&](const qsys::Instance& instance, const qsys::Parameters& parameters) {
                    return components_.describe(system, instance, parameters);
                });
        } catch (const qsys::UnknownKind& error) {
            const auto qip = qip_of_system(file, files_.finder());
            if (!qip) throw;
            note(fmt::format("{}; what Platform Designer has made of it is taken, {}", error.what(),
                             files_.place(*qip)));
            as_made_.insert(lower(file.stem().string()));
            for (const Assignment& inner : settings_of(*qip)) apply(inner);
            return;
        }
        files_.add({file, Language::VERILOG, true, {}, made.text});
        for (const fs::path& source : made.sources) {
            std::error_code error;
            if (const auto language = language_of(source); !fs::is_regular_file(source, error))
                note(fmt::format("{}: {} is not there", files_.place(file), files_.place(source)));
            else
                files_.add({source, *language, true, {}});
        }
        for (const std::string& text : made.notes) note(text);
        project_.systems.push_back(std::move(made));
    }

    // Of the processor that a module of the design instances primitives of.
    void add_processor(const std::string& module) {
        for (const qsys::Generated& system : project_.systems)
            if (system.has_processor) return;
        project_.systems.push_back(processor_of_primitives(files_, module));
        for (const std::string& text : project_.systems.back().notes)
            note(fmt::format(
                "{}: {}", files_.place(files_.source(files_.definition(module)->source).file.path),
                text));
    }

    void add_source(const Assignment& a) {
        const auto file = resolve(a);
        if (!file) return;
        if (!as_made_.count(lower(file->stem().string())) &&
            is_made_of_processor_system(*file, files_.finder()))
            return;
        const auto by_ending = language_of(*file);
        Language language = by_ending.value_or(Language::VERILOG);
        if (language == Language::VERILOG && is_system_verilog_)
            language = Language::SYSTEM_VERILOG;
        if (a.name == "SYSTEMVERILOG_FILE") language = Language::SYSTEM_VERILOG;
        if (a.name == "VHDL_FILE") language = Language::VHDL;
        const std::string library = lower(a.library) == "work" ? "" : lower(a.library);
        if (language == Language::VHDL && !library.empty())
            project_.vhdl_libraries[library].push_back(*file);
        files_.add({*file, language, true, library});
    }

    // ProjectError: there is a file that cannot be simulated, for this module or at all.
    void refuse_files(const std::string& module = {}) const {
        for (const fs::path& file : files_.finder().files())
            if (const auto why = unsupported_file(file);
                why && (module.empty() || lower(file.stem().string()) == lower(module)))
                throw ProjectError{fmt::format("{}: {}", files_.place(file), *why)};
    }
    // Why a module that the sources name is not there, if that is known.  Whether the design needs
    // it, elaboration tells: a `generate` may leave it out.
    std::string reason_for_missing() const {
        for (const auto& [module, by] : missing_)
            if (const auto why = unsupported_module(module))
                return fmt::format("{}: module {}, which {} wants: {}", folder_.string(), module,
                                   by, *why);
        try {
            for (const auto& [module, by] : missing_) refuse_files(module);
        } catch (const ProjectError& error) {
            return error.what();
        }
        if (missing_.empty()) return {};
        const std::string wanted =
            fmt::format(" (module {}, which {} wants)", missing_[0].first, missing_[0].second);
        if (!unsupported_.empty()) return unsupported_.front() + wanted;
        return encrypted_file(wanted);
    }

    // The file of a missing module's name; else one of Verilog, which may have any module.
    std::string encrypted_file(const std::string& wanted) const {
        const auto said = [this](const fs::path& file, const std::string& of) {
            return files_.place(file) + ": " + ENCRYPTED + of;
        };
        for (const auto& [module, by] : missing_)
            for (const fs::path& file : files_.encrypted())
                if (file.stem() == module)
                    return said(file, fmt::format(" (module {}, which {} wants)", module, by));
        for (const fs::path& file : files_.encrypted())
            if (const auto ending = file.extension(); ending != ".vhd" && ending != ".vhdl")
                return said(file, wanted);
        return {};
    }

    void choose_board() {
        BoardChoice choice =
            project::choose_board(all_boards(), {request_.board, device_, project_.pins});
        for (std::string& text : choice.notes) note(std::move(text));
        project_.board = std::move(choice.board);
        project_.is_for_other_device = choice.is_for_other_device;
        if (choice.is_for_other_device) project_.pins.clear();
    }

    void choose_top() {
        if (!project_.top.empty() && files_.definition(project_.top)) return;
        if (!project_.top.empty()) refuse_files(project_.top);
        if (!request_.top.empty())
            throw ProjectError{fmt::format("--top {}: no file defines that module", request_.top)};
        if (!place_of_top_.empty() && files_.size() > 0) refuse_top();
        const auto top = top_module_by_pins(files_, folder_, project_.board);
        if (!top && !unsupported_.empty()) throw ProjectError{unsupported_.front()};
        if (!top)
            throw ProjectError{fmt::format(
                "{}: {}; no module has the board's pins as ports (CLOCK_50, KEY, VGA_R ...)",
                (settings_.empty() ? folder_ : settings_).string(),
                project_.top.empty() ? "no top module is named"
                                     : "the top module " + project_.top + " is not there")};
        note(top->note);
        project_.top = top->name;
    }

    void refuse_top() const {
        constexpr unsigned MOST = 6;
        std::string others;
        unsigned count = 0;
        for (const auto& [name, d] : files_.modules())
            if (!d.module->is_package && ++count <= MOST)
                others += (others.empty() ? "" : ", ") + name;
        if (count > MOST) others += " ...";
        throw ProjectError{fmt::format(
            "{}: Quartus error 12007: no file defines the top-level entity {}; the files define {}",
            place_of_top_, project_.top, others.empty() ? "no module" : others)};
    }

    // Two files of one library that are listed cannot define a module.
    void refuse_rivals() const {
        for (const auto& [name, rivals] : files_.rivals())
            for (const Definition& second : rivals)
                for (const Definition& first : rivals) {
                    if (&first == &second) break;
                    const SourceFile &a = files_.source(first.source).file,
                                     &b = files_.source(second.source).file;
                    if (a.listed && b.listed && a.library == b.library &&
                        a.language != Language::VHDL && b.language != Language::VHDL)
                        throw ProjectError{fmt::format(
                            "{}:{}: Quartus error 10228: module {} is declared at {}:{}, too; take "
                            "one of the files out of the project",
                            files_.place(b.path), second.module->line, name, files_.place(a.path),
                            first.module->line)};
                }
    }

    // That of a file, or of a Platform Designer system that is not listed.
    const Definition* definition(const std::string& name, bool from_vhdl) {
        const auto systems = files_.finder().with_name(name + ".qsys");
        const bool is_made = !systems.empty() && !files_.modules().count(name) &&
                             (has_processor(systems.front(), files_.finder()) ||
                              !files_.definition(name, from_vhdl));
        if (is_made) {
            note(fmt::format("{}: {} is made of it", files_.place(systems.front()), name));
            add_system(systems.front());
        }
        return files_.definition(name, from_vhdl);
    }

    // The module that the vendor's generator makes of a system's instance, which a design may
    // instance, too.
    bool add_instance_module(const std::string& name) {
        for (const qsys::Generated& system : project_.systems) {
            const auto found = system.instance_modules.find(name);
            if (found == system.instance_modules.end()) continue;
            files_.add({folder_ / (name + ".v"), Language::VERILOG, true, {}, found->second});
            return true;
        }
        return false;
    }

    void collect_what_it_needs() {
        std::set<std::string> seen;
        std::set<std::size_t> packages, others;
        std::deque<std::pair<std::string, std::string>> open{{project_.top, ""}};
        while (!open.empty()) {
            const auto [name, by] = open.front();
            open.pop_front();
            if (!seen.insert(name).second) continue;
            const Definition* user = by.empty() ? nullptr : files_.definition(by);
            const bool from_vhdl = user && files_.is_vhdl(*user);
            if (request_.is_model(from_vhdl ? lower(name) : name) &&
                !files_.modules().count(name)) {
                if (is_processor_primitive(name)) add_processor(by);
                continue;
            }
            const Definition* d = definition(name, from_vhdl);
            if (!d && add_instance_module(name)) d = files_.definition(name, from_vhdl);
            if (!d) {
                if (!by.empty()) missing_.emplace_back(name, by);
                continue;
            }
            // The top is wanted by nobody: the nearest to the folder itself.
            if (is_folder_alone_)
                files_.choose_nearest(d->module->name,
                                      user ? files_.source(user->source).file.path : folder_ / "");
            if (files_.is_vhdl(*d) && !d->module->is_package && !from_vhdl)
                project_.entities.push_back(name);
            (d->module->is_package ? packages : others).insert(d->source);
            const SourceText& text = files_.source(d->source).text;
            for (const std::string& package : text.packages) open.emplace_back(package, name);
            for (const std::string& wanted : d->module->wants) open.emplace_back(wanted, name);
        }
        for (const auto* group : {&packages, &others})
            for (const std::size_t n : files_.in_order(*group))
                if (group == &packages || !packages.count(n))
                    project_.sources.push_back(files_.source(n).file);
        for (std::size_t n = 0; n < files_.size() && !project_.entities.empty(); ++n) {
            const ModuleFiles::Source& source = files_.source(n);
            // GHDL would take the last definition that it reads.
            if (source.file.language == Language::VHDL &&
                !(is_folder_alone_ && files_.is_passed_over(source)))
                project_.vhdl.push_back(source.file.path);
        }
        std::set<fs::path> folders{folder_};
        for (const SourceFile& source : project_.sources) folders.insert(source.path.parent_path());
        project_.includes.insert(project_.includes.end(), folders.begin(), folders.end());
        project_.why_missing = reason_for_missing();
        if (!project_.entities.empty() && !project_.why_missing.empty())
            throw ProjectError{project_.why_missing};
        for (const SourceFile& source : project_.sources)
            if (files_.encrypted().count(source.path))
                throw ProjectError{files_.place(source.path) + ": " + ENCRYPTED};
        for (const std::string& line : unsupported_) note(line);
        for (const SourceFile& source : project_.sources)
            for (const auto& [module, d] : files_.modules())
                if (request_.is_model(module) && files_.source(d.source).file.path == source.path)
                    note(fmt::format("12090: module {} is that of {}, and not Quartus' own", module,
                                     files_.place(source.path)));
        if (!project_.entities.empty()) note("VHDL goes through GHDL, which is experimental");
    }

    const Request& request_;
    const fs::path settings_, folder_;
    Project project_;
    ModuleFiles files_;
    PlatformComponents components_;
    std::vector<std::string> unsupported_;
    std::vector<std::pair<std::string, std::string>> missing_;  // modules, with who wants them
    std::string device_;                                        // or empty
    std::string place_of_top_;                                  // where the settings name it
    std::vector<fs::path> listed_systems_;                      // taken after the other files
    std::set<fs::path> systems_;                                // that have been taken
    std::set<std::string> as_made_;   // names of those that Platform Designer has made
    bool is_folder_alone_ = false;    // no files are listed
    bool is_system_verilog_ = false;  // .v files, too
};

}  // namespace

std::string SourceFile::whole_text() const { return text.empty() ? text_of(path) : text; }

Project read_project(const Request& request) {
    ProjectReader reader{request};
    try {
        return reader.run();
    } catch (ProjectError& error) {
        error.notes = reader.notes();
        throw;
    }
}

}  // namespace sim::project
