#include "sim/suite/hand_ins.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/files/whole_file.h"
#include "sim/project/compiled_headers.h"
#include "sim/scenario/scenario.h"
#include "sim/text/printable.h"

namespace sim::suite {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t MAX_SCENARIO_BYTES = 1u << 20;
constexpr const char* COPY = "hand-in";
constexpr const char* BUILT_BY_DE1SIM = ".de1sim";  // it has a library that de1sim loads

std::string path_in(const fs::path& folder, const fs::path& file) {
    return fs::absolute(file)
        .lexically_normal()
        .lexically_relative(fs::absolute(folder.empty() ? "." : folder).lexically_normal())
        .string();
}

bool is_within(const fs::path& inner, const fs::path& outer) {
    const fs::path way =
        fs::weakly_canonical(inner).lexically_relative(fs::weakly_canonical(outer));
    return !way.empty() && *way.begin() != "..";
}

// Without what de1sim has built in it, and with its links as they are.
void copy_of(const fs::path& from, const fs::path& to) {
    fs::remove_all(to);
    make_folder(to.parent_path());
    fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    std::vector<fs::path> built;
    for (const auto& entry : fs::recursive_directory_iterator{to})
        if (entry.path().filename() == BUILT_BY_DE1SIM) built.push_back(entry.path());
    for (const fs::path& one : built) fs::remove_all(one);
}

std::uint64_t bytes_in(const fs::path& folder) {
    std::uint64_t bytes = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator at{folder, error}, end; at != end; at.increment(error)) {
        const auto size = at->is_regular_file(error) ? at->file_size(error) : 0;
        if (!error) bytes += size;
    }
    return bytes;
}

}  // namespace

HandIns::HandIns(const HandInOptions& options, const std::vector<fs::path>& paths, fs::path out)
    : options_{options}, out_{std::move(out)} {
    const std::string shown = printable(options_.folder.string());
    std::error_code error;
    for (const auto& entry : fs::directory_iterator{options_.folder, error})
        if (entry.is_directory() && !entry.is_symlink() &&
            entry.path().filename().string().front() != '.')
            names_.push_back(entry.path().filename().string());
    if (names_.empty())
        throw std::runtime_error{"--hand-ins: " + shown +
                                 ": expected a folder with a folder for "
                                 "each hand-in, got " +
                                 (error ? error.message() : "none")};
    std::sort(names_.begin(), names_.end());
    for (const std::string& name : names_) prepared_[name];
    for (const fs::path& path : paths) {
        if (is_within(options_.folder, path))
            throw std::runtime_error{"--hand-ins: " + shown + " lies in " +
                                     printable(path.string()) +
                                     ", the folder of the scenarios; "
                                     "name one beside it"};
        const fs::path folder = fs::is_directory(path) ? path : fs::absolute(path).parent_path();
        confinement_.readable.push_back(folder);
        for (const fs::path& other : {options_.folder, out_})
            if (is_within(other, folder)) confinement_.hidden.push_back(other);
    }
    if (fs::is_directory(project::user_cache(), error)) confinement_.cache = project::user_cache();
    confinement_.memory_bytes = std::uint64_t{options_.memory_mb} * 1'000'000;
    confinement_.file_bytes = std::uint64_t{options_.output_mb} * 1'000'000;
    if (!options_.unconfined) check_confinement();
}

std::vector<Case> HandIns::cases(const std::vector<Case>& scenarios) const {
    std::vector<Case> all;
    for (const Case& scenario : scenarios) {
        std::optional<Scenario> read;
        try {
            read =
                parse_scenario(read_whole_file(scenario.file, MAX_SCENARIO_BYTES), scenario.file);
        } catch (const std::runtime_error&) {
            // Its run will say what is wrong with it.
        }
        const bool is_program = read && !read->program.empty();
        const fs::path judged = is_program ? read->program : read ? read->project : fs::path{};
        if (judged.empty() && read)
            throw std::runtime_error{printable(scenario.file.string()) +
                                     ": expected `program:` or `project:`, the file that each "
                                     "hand-in has under this name"};
        const std::string file = judged.empty() ? "" : path_in(scenario.file.parent_path(), judged);
        for (const std::string& name : names_) {
            Case one = scenario;
            one.name = name + "/" + scenario.name;
            one.hand_in = name;
            if (read)
                (is_program ? one.program : one.project) =
                    (out_ / "runs" / one.name / COPY / file).lexically_normal();
            all.push_back(std::move(one));
        }
    }
    return all;
}

const std::string& HandIns::prepare(const std::string& name, unsigned limit_s) {
    Prepared& one = prepared_.at(name);
    std::call_once(one.once, [&] { one.problem = build(name, limit_s); });
    return one.problem;
}

std::string HandIns::build(const std::string& name, unsigned limit_s) const {
    const fs::path folder = out_ / "hand-ins" / name;
    try {
        copy_of(options_.folder / name, folder);
        if (options_.build.empty()) return "";
        const Outcome outcome =
            run_confined({"sh", "-c", "cd \"$1\" && " + options_.build, "sh", folder.string()},
                         folder, limit_s, [] { return false; });
        if (outcome.code == TIMED_OUT)
            return fmt::format("the build did not end within {} s", limit_s);
        if (outcome.code == WROTE_TOO_MUCH)
            return fmt::format("the build wrote more than {} MB", options_.output_mb);
        return outcome.code == 0 ? "" : outcome.output;
    } catch (const fs::filesystem_error& error) {
        return error.what();
    }
}

Outcome HandIns::run(const Case& one, const std::vector<std::string>& command,
                     const fs::path& folder, unsigned limit_s,
                     const std::function<bool()>& given_up) const {
    // A copy for each run, since a project's Verilog may write beside itself.
    copy_of(out_ / "hand-ins" / one.hand_in, folder / COPY);
    const Outcome outcome = run_confined(command, folder, limit_s, given_up);
    fs::remove_all(folder / COPY);
    return outcome;
}

Outcome HandIns::run_confined(const std::vector<std::string>& command, const fs::path& writable,
                              unsigned limit_s, const std::function<bool()>& given_up) const {
    Confinement confinement = confinement_;
    confinement.writable = {writable};
    bool too_much = false;
    Outcome outcome = run_command(options_.unconfined ? command : confined(command, confinement),
                                  ".", limit_s, [&] {
                                      too_much = bytes_in(writable) > confinement_.file_bytes;
                                      return too_much || given_up();
                                  });
    if (too_much) outcome.code = WROTE_TOO_MUCH;
    return outcome;
}

}  // namespace sim::suite
