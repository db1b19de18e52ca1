#include "sim/vhdl/vhdl.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/process/run_command.h"
#include "sim/text/lower.h"
#include "sim/verilog/project_error.h"
#include "sim/vhdl/vhdl_dialect.h"
#include "sim/vhdl/vhdl_files.h"
#include "sim/vhdl/vhdl_repairs.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// "GHDL 2.0.0 crashed on this VHDL ...", where it says so itself.
std::optional<std::string> crash(const std::string& output) {
    if (output.find("GHDL Bug occurred") == std::string::npos) return {};
    static const std::string RELEASE = "GHDL release: ";
    std::string version;
    if (const std::size_t at = output.find(RELEASE); at != std::string::npos) {
        const std::size_t begin = at + RELEASE.size();
        version = " " + output.substr(begin, output.find_first_of(" \n", begin) - begin);
    }
    return fmt::format("GHDL{} crashed on this VHDL; a newer GHDL may take it", version);
}

// The latest place that GHDL wrote before `at`, "top.vhd:11", from "/* top.vhd:11:3  */".
std::string place_before(const std::string& verilog, std::size_t at) {
    const std::size_t open = verilog.rfind("/* ", at);
    if (open == std::string::npos) return {};
    const std::string place = verilog.substr(open + 3, verilog.find(' ', open + 3) - open - 3);
    return place.substr(0, place.rfind(':'));
}

// ProjectError: a register that no clock alone makes, for which GHDL has a cell of its own.
void refuse_two_clocks(const std::string& verilog) {
    const std::size_t at = verilog.find("gate_mdff");
    if (at != std::string::npos)
        throw ProjectError{fmt::format(
            "{}: Quartus error 10820: the register has more than one clock, or both edges of one; "
            "a register has one edge of one clock",
            place_before(verilog, at))};
}

// Whether a process of `vhdl`, in small letters, assigns `signal` in a branch before its clock's.
bool loads_without_clock(const std::string& vhdl, const std::string& signal) {
    static const std::string END = "end process";
    const std::regex assigns{"\\b" + signal + "\\b[^;]*<="},
        clock{"elsif[^;]*(rising_edge|falling_edge|'event)"};
    std::size_t begin = 0;
    for (std::size_t end; (end = vhdl.find(END, begin)) != std::string::npos;
         begin = end + END.size()) {
        const std::size_t open = vhdl.rfind("process", end - 1);
        if (open == std::string::npos || open < begin) continue;
        const std::string process = vhdl.substr(open, end - open);
        if (std::regex_search(process, assigns) && std::regex_search(process, clock)) return true;
    }
    return false;
}

// ProjectError: a register that is loaded without a clock and keeps its value at the clock, which
// GHDL takes for nothing at all.
void refuse_lost_registers(const std::string& verilog, const std::string& vhdl) {
    static const std::regex LOST{"\n  assign ([a-zA-Z][a-zA-Z0-9_]*) = [0-9]+'bX; // \\(signal\\)"};
    for (std::sregex_iterator at{verilog.begin(), verilog.end(), LOST}, end; at != end; ++at)
        if (loads_without_clock(vhdl, lower((*at)[1].str())))
            throw ProjectError{fmt::format(
                "{}: GHDL leaves out {}, which is loaded without a clock and not changed by one: "
                "write it as a latch, without the clock",
                place_before(verilog, static_cast<std::size_t>(at->position())), (*at)[1].str())};
}

// GHDL's words for what Quartus has a number of.
std::string in_quartus_words(const std::string& line) {
    static const std::regex SAID{
        "^(.*?:[0-9]+):[0-9]+: ?(latch infered for net|multiple assignments for) \"([^\"]*)\".*"};
    std::smatch m;
    if (!std::regex_match(line, m, SAID)) return line;
    return fmt::format("{}: Quartus error 10028: {} has two drivers{}: drive it in one process{}",
                       m[1].str(), m[3].str(),
                       m[2].str()[0] == 'l' ? ", or keeps its value without a clock" : "",
                       m[2].str()[0] == 'l' ? ", and assign it on all paths through that" : "");
}

// GHDL's first error, or what it says instead: "top.vhd:14:2: no declaration for "x"".  GHDL 5 puts
// "error:" before it, and names a unit that it has not found as one of its command line.
std::string first_error(const std::string& output, const std::string& what) {
    if (const auto crashed = crash(output)) return fmt::format("{}: {}", what, *crashed);
    std::istringstream lines{output};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':');
        const bool has_place = colon != std::string::npos && colon + 1 < line.size() &&
                               std::isdigit(static_cast<unsigned char>(line[colon + 1]));
        if (has_place && line.find(":warning:") == std::string::npos &&
            line.find(":note:") == std::string::npos && line[0] != '*') {
            static const std::string MARK = ":error: ";
            const std::size_t mark = line.find(MARK);
            return in_quartus_words(
                mark == std::string::npos ? line : line.replace(mark, MARK.size(), ": "));
        }
    }
    return fmt::format("{}: GHDL failed on this VHDL, and does not say why", what);
}

// The library `file`, `"a.vhd" "checksum" "20261123112025.189";` in it, with one time for all: GHDL
// takes a unit for out of date if one that it needs has been found a millisecond later.
void have_one_time(const fs::path& file) {
    std::istringstream lines{text_of(file)};
    std::string text, time;
    for (std::string line; std::getline(lines, line); text += line + "\n") {
        if (line.rfind("file ", 0) != 0) continue;
        const std::size_t at = line.rfind(" \"");
        if (time.empty()) time = line.substr(at);
        line.replace(at, std::string::npos, time);
    }
    write_whole_file(file, text);
}

// What GHDL refuses, with all that it printed.
class Refusal : public ProjectError {
public:
    Refusal(const std::string& what, std::string all)
        : ProjectError{what}, output{std::move(all)} {}
    const std::string output;
};

// All runs of GHDL for a design.
class Translation {
public:
    Translation(const VhdlDesign& design, VhdlFiles& files, const TimeLimit& limit)
        : design_{design}, files_{files}, limit_{limit}, paths_{design.files} {
        // The last one of two entities of one name counts.
        std::stable_partition(paths_.begin(), paths_.end(),
                              [&](const fs::path& file) { return design.needed.count(file) == 0; });
        for (const fs::path& file : paths_) {
            words_.push_back(files_.word(file));
            all_ += lower(text_of(file));
        }
    }

    std::vector<std::string> run() {
        std::error_code error;
        fs::remove_all(library_folder(), error);
        fs::create_directories(library_folder());
        analyse_libraries();
        import();
        analyse_roots();
        std::set<std::string> known;
        std::vector<std::string> texts;
        for (const VhdlRoot& root : design_.roots) texts.push_back(verilog_of(root, known));
        return texts;
    }

private:
    fs::path library_folder() const { return design_.work / "libraries"; }

    // As much as Quartus takes: the libraries of Synopsys, shared variables, undriven outputs.
    Outcome outcome_of(const std::vector<std::string>& first,
                       const std::vector<std::string>& last) const {
        std::vector<std::string> words{"ghdl"};
        words.insert(words.end(), first.begin(), first.end());
        words.insert(words.end(),
                     {"--std=08", "-fsynopsys", "-frelaxed", "-fno-caret-diagnostics",
                      "--workdir=" + library_folder().string(), "-P" + library_folder().string()});
        words.insert(words.end(), last.begin(), last.end());
        Outcome outcome = run_command(words, design_.folder, limit_.left_s());
        outcome.output = files_.in_own_names(std::move(outcome.output));
        return outcome;
    }
    std::string run_ghdl(const std::vector<std::string>& first,
                         const std::vector<std::string>& last) const {
        const Outcome outcome = outcome_of(first, last);
        if (outcome.code == 127)
            throw ProjectError{
                "the project has VHDL, for which ghdl is not installed: apt install ghdl"};
        if (outcome.code == TIMED_OUT)
            throw ProjectError{
                fmt::format("the build has not ended in {} s (--build-limit): ghdl was at work",
                            limit_.seconds())};
        if (outcome.code != 0)
            throw Refusal{first_error(outcome.output, files_.in_own_names(last.back())),
                          outcome.output};
        return outcome.output;
    }

    void analyse_libraries() {
        for (const auto& [name, text] : design_.libraries) {
            if (all_.find(name) == std::string::npos) continue;
            const fs::path file = library_folder() / (name + ".vhd");
            write_whole_file(file, text);
            run_ghdl({"-a", "--work=" + name}, {file.string()});
        }
        for (const auto& [name, own] : design_.own_libraries) {
            if (all_.find("library " + name) == std::string::npos) continue;
            std::vector<std::string> of_library;
            for (const fs::path& file : own) of_library.push_back(files_.word(file));
            run_ghdl({"-a", "--work=" + name}, of_library);
        }
    }

    void import() {
        try {
            run_ghdl({"-i"}, words_);
        } catch (const ProjectError&) {
            for (std::size_t n = 0; n < words_.size(); ++n) try {
                    run_ghdl({"-i"}, {words_[n]});
                } catch (const ProjectError&) {
                    if (design_.needed.count(paths_[n])) throw;
                }
        }
        have_one_time(library_folder() / "work-obj08.cf");
    }

    // A component is bound to an entity only if that has been analysed.  Errors of GHDL 2 come
    // again below; GHDL 5 says there only that the entity has not been analysed.
    void analyse_roots() {
        for (const VhdlRoot& root : design_.roots)
            if (!analysed_.count(root.entity))
                analysed_[root.entity] = outcome_of({"-m"}, {name_for_ghdl(root.entity)}).output;
    }

    std::string verilog_of(const VhdlRoot& root, std::set<std::string>& known) const {
        std::string output = "\n" + synthesised(root, "--out=verilog");
        output.erase(0, output.find("\nmodule ") + 1);  // its warnings
        refuse_two_clocks(output);
        refuse_lost_registers(output, all_);
        output = repaired(output, lacks_others(output) ? synthesised(root, "--out=raw-vhdl") : "");
        try {
            return VhdlOutput{output, root.entity, root.module, design_.in_verilog}.without(known);
        } catch (const ProjectError&) {
            // Perhaps there is that entity, but GHDL has refused it.
            const std::string& printed = analysed_.at(root.entity);
            const std::string before = first_error(printed, root.entity);
            if (before.compare(0, root.entity.size() + 1, root.entity + ":") == 0) throw;
            throw Refusal{before, printed};
        }
    }

    std::string synthesised(const VhdlRoot& root, const char* out) const {
        std::vector<std::string> last = root.generics;
        for (std::string& option : last) {  // -gNAME=VALUE
            const std::size_t end = option.find('=');
            option = "-g" + name_for_ghdl(option.substr(2, end - 2)) + option.substr(end);
        }
        last.push_back(name_for_ghdl(root.entity));
        try {
            return run_ghdl({"--synth", out}, last);
        } catch (const Refusal& refusal) {
            // What has no place of its own begins with the entity.  A body that is outdated had an
            // error before.
            const std::string what = refusal.what(), entity = root.entity + ": ";
            const bool is_outdated = what.find(" is outdated") != std::string::npos;
            if (!is_outdated && what.compare(0, entity.size(), entity) != 0) throw;
            const std::string& printed = analysed_.at(root.entity);
            const std::string before = first_error(printed, root.entity);
            if (before.compare(0, entity.size(), entity) != 0) throw Refusal{before, printed};
            if (is_outdated) throw;
            throw ProjectError{file_of(root.entity) + what.substr(root.entity.size())};
        }
    }

    std::string file_of(const std::string& entity) const {
        for (const fs::path& path : paths_)
            if (lower(text_of(path)).find("entity " + lower(entity)) != std::string::npos)
                return files_.name(path);
        return entity;
    }

    const VhdlDesign& design_;
    VhdlFiles& files_;
    const TimeLimit& limit_;
    std::vector<fs::path> paths_;
    std::vector<std::string> words_;               // for GHDL's command, of each of them
    std::string all_;                              // their text, in small letters
    std::map<std::string, std::string> analysed_;  // by the entity, what GHDL printed
};

}  // namespace

std::vector<std::string> verilog_of(const VhdlDesign& design, const TimeLimit& limit) {
    std::error_code error;
    fs::remove_all(design.work, error);
    fs::create_directories(design.work);
    VhdlFiles files{design.folder, design.work / "files", design.initial_words};
    for (;;) try {
            return Translation{design, files, limit}.run();
        } catch (const Refusal& refusal) {
            if (!files.rewrite_choices(refusal.output))
                throw ProjectError{files.cause(refusal.what())};
        }
}

}  // namespace sim::project
