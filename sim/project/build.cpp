#include "sim/project/build.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include "sim/files/sha256.h"
#include "sim/files/whole_file.h"
#include "sim/project/chip_text.h"
#include "sim/project/clean_sources.h"
#include "sim/project/compiled_headers.h"
#include "sim/project/generated.h"
#include "sim/project/init_checks.h"
#include "sim/project/syntax_tree.h"
#include "sim/project/tools.h"
#include "sim/verilog/file_finder.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

std::string hash_of(const std::string& text) {
    return sha256_hex(text.data(), text.size()).substr(0, 16);
}

// C functions that the design imports (DPI): Verilator's header of them has only the models' own.
void refuse_foreign_functions(const fs::path& objects) {
    std::ifstream header{objects / "Vde1sim_chip__Dpi.h"};
    for (std::string line; std::getline(header, line);)
        if (line.find(" extern ") != std::string::npos &&
            line.find(" de1sim_analog_") == std::string::npos &&
            line.find(" de1sim_init_") == std::string::npos &&
            line.find(" de1sim_jtag_") == std::string::npos &&
            line.find(" de1sim_pll_") == std::string::npos &&
            line.find(" de1sim_hps_") == std::string::npos)
            throw ProjectError{
                "a function of C is imported (DPI): " + line.substr(line.find("extern ") + 7) +
                " runs code of this machine, which no board has; take it out"};
}

// de1sim's own project, in which a link to de1sim's data would lead back to itself.
bool is_in_data(const fs::path& folder) {
    const fs::path data = fs::weakly_canonical(data_folder() / "rtl/board");
    const std::string below = fs::weakly_canonical(folder).lexically_relative(data).string();
    return !below.empty() && below.compare(0, 2, "..") != 0;
}

// Where the project's folder cannot be written to, the user's cache.
fs::path place_for(const fs::path& folder) {
    if (is_writable(folder) && !is_in_data(folder)) return folder / ".de1sim";
    const fs::path cache = user_cache();
    return (cache.empty() ? fs::temp_directory_path() / "de1sim" : cache) /
           hash_of(folder.string());
}

std::vector<std::string> verilator_command(const Project& project,
                                           const std::vector<std::string>& includes) {
    std::vector<std::string> command{"verilator",
                                     "-Wno-fatal",
                                     "-Wno-lint",
                                     "-Wno-style",
                                     "-Wno-ASSIGNIN",
                                     "-Wno-BLKANDNBLK",
                                     "-Wno-STMTDLY",
                                     "-Wno-MULTIDRIVEN",
                                     "-Wno-UNOPTFLAT",
                                     "-Wno-TIMESCALEMOD",
                                     "-Wno-COMBDLY",
                                     "-Wno-INITIALDLY",
                                     "-Wno-PINMISSING",
                                     "-Wno-MODDUP",
                                     "-Wno-SYMRSVDWORD",
                                     "-Wno-SPLITVAR",
                                     "-Wno-TICKCOUNT",
                                     "--no-timing",
                                     "--timescale",
                                     "1ns/1ps",
                                     "--timescale-override",
                                     "/1ps",
                                     "--x-initial",
                                     "0",
                                     "--x-assign",
                                     "0"};
    command.insert(command.end(),
                   {"-DALTERA_RESERVED_QIS", "-UVERILATOR", "-Uverilator", "-Uverilator3"});
    for (const std::string& macro : project.macros) command.push_back("-D" + macro);
    command.push_back("-Iincluded");
    for (const std::string& include : includes) command.push_back("-I" + include);
    command.insert(command.end(), {"-y", "data/rtl/ip", "-y", "data/rtl/ip/qsys", "-Idata/rtl/ip",
                                   "data/project/de1sim_init.sv"});
    return command;
}

std::string state_of(const fs::path& file) {
    return fmt::format("{} {}\n", fs::file_size(file),
                       fs::last_write_time(file).time_since_epoch().count());
}

}  // namespace

Builder::Builder(const Request& request, bool trace)
    : request_{request}, trace_{trace}, limit_{request.build_limit_s} {
    request_.is_model = [](const std::string& module) {
        return model_of(module).has_value() || module == "tri";  // in VHDL
    };
}

void Builder::prepare_folder() {
    fs::create_directories(folder_ / "source");
    fs::create_directories(folder_ / "included");
    lock_.acquire(folder_ / "lock");
    link_to(data_folder(), folder_ / "data");
    includes_.clear();
    for (const fs::path& include : design_.project.includes)
        includes_.push_back(
            seen_from(folder_, include, fmt::format("include{}", includes_.size())));
}

void Builder::elaborate() {
    read_clean_sources();
    refuse(text_errors(checks_));  // before Verilator reports them otherwise
    verilator_ = find_verilator(limit_);
    while (!write_tree()) {
    }
}

// Of the last elaboration: a design is elaborated again where Verilator has told what it lacks.
fs::path Builder::tree() const {
    return folder_ / fmt::format("design{}.{}", elaborations_, as_json_ ? "json" : "xml");
}

// False: it has to be elaborated once more, otherwise.
bool Builder::write_tree() {
    ++elaborations_;
    auto command = verilator_command(design_.project, includes_);
    command.insert(command.end(), {"-O0", "-Wwarn-lint", "-Wwarn-PINMISSING", "-DDE1SIM_LISTS",
                                   "--Mdir", "tree", "--top-module", design_.project.top});
    const std::string written = tree().filename();
    if (as_json_)
        command.insert(command.end(), {"--json-only", "--json-only-output", written,
                                       "--json-only-meta-output", tree_meta(written)});
    else
        command.insert(command.end(), {"--xml-only", "--xml-output", written});
    const auto parameters = verilator_options(design_.project.parameters);
    command.insert(command.end(), parameters.begin(), parameters.end());
    for (const fs::path& file : files_) command.push_back(file.string());
    // The command's key, and what was printed: with a tree, or with an error that was mended.
    const std::string key = key_of(command);
    const std::string with_tree = key + " tree\n", with_error = key + " error\n";
    const fs::path kept = folder_ / fmt::format("design{}.kept", elaborations_);
    std::error_code error;
    const std::string text = fs::is_regular_file(kept, error) ? text_of(kept) : "";
    if (text.compare(0, with_tree.size(), with_tree) == 0 && fs::is_regular_file(tree(), error)) {
        verilator_output_ = text.substr(with_tree.size());
        return true;
    }
    try {
        if (text.compare(0, with_error.size(), with_error) == 0)
            throw ProjectError{text.substr(with_error.size())};
        fs::remove(kept, error);
        verilator_output_ = run_tool(command, folder_, limit_);
    } catch (const ProjectError& e) {
        if (!mend(e.what())) throw;
        write_whole_file(kept, with_error + e.what());
        return false;
    }
    write_whole_file(kept, with_tree + verilator_output_);
    return true;
}

// Whether the next elaboration is without what this error of Verilator's is about.  ProjectError:
// its cause is known.
bool Builder::mend(const std::string& said) {
    if (!design_.project.why_missing.empty() &&
        (said.find("12006: no file defines module") != std::string::npos ||
         said.find("pragma protect") != std::string::npos))  // in an encrypted file
        throw ProjectError{design_.project.why_missing};
    if (!as_json_ && said.find("--xml-only") != std::string::npos) return as_json_ = true;
    if (fit_inout(said)) return true;
    // Parameters that the top has not are left out, as Quartus does.  Many are the global ones of
    // Intel's IP.
    bool left_out = false;
    for (const std::string& name : unknown_parameters(said)) {
        const auto set = design_.project.parameters.find(name);
        if (set == design_.project.parameters.end()) continue;
        design_.project.notes.push_back(
            fmt::format("{}: set_parameter {} is passed over: {} has no such parameter",
                        set->second.place, name, design_.project.top));
        design_.project.parameters.erase(set);
        left_out = true;
    }
    return left_out;
}

// False: the error is another than of an inout port that is connected with more or fewer bits.
bool Builder::fit_inout(const std::string& error) {
    static const std::regex SAID{
        "^(.*):([0-9]+): .*Inout port connection '([^']*)' to inout signal requires ([0-9]+) bits, "
        "but connection's .* generates ([0-9]+) bits.*"};
    std::smatch m;
    if (!std::regex_match(error, m, SAID)) return false;
    if (!add_fit(m)) return false;
    read_clean_sources();
    return true;
}

// What Verilator has said of a connection: file, line, port, its bits, those of the wire.  False:
// it is known.
bool Builder::add_fit(const std::smatch& said) {
    const InoutFit fit{static_cast<unsigned>(std::stoul(said[2])), said[3],
                       static_cast<unsigned>(std::stoul(said[4])),
                       static_cast<unsigned>(std::stoul(said[5]))};
    auto& fits = inout_fits_[said[1]];
    const auto same = [&](const InoutFit& o) { return o.line == fit.line && o.port == fit.port; };
    if (std::any_of(fits.begin(), fits.end(), same)) return false;
    fits.push_back(fit);
    return true;
}

// Quartus leaves the upper bits of a wire alone that is wider than the output it is connected with
// (12030); Verilator drives them with 0, and so beside another driver.  False: there is none such.
bool Builder::fit_outputs() {
    static const std::regex SAID{
        "%Warning-[A-Z]+: ([^:]*):([0-9]+):[0-9]+: Output port connection '([^']*)' expects "
        "([0-9]+) bits on the pin connection, but pin connection's VARREF '[^']*' generates "
        "([0-9]+) bits"};
    bool is_new = false;
    const std::string& all = verilator_output_;
    for (std::sregex_iterator said{all.begin(), all.end(), SAID}, end; said != end; ++said)
        if (std::stoul((*said)[5]) > std::stoul((*said)[4])) is_new |= add_fit(*said);
    return is_new;
}

void Builder::read_clean_sources() {
    CleanSources clean = clean_sources(
        {design_.project, entities_, request_.is_model, folder_, limit_, inout_fits_});
    files_ = std::move(clean.files);
    design_.changes = std::move(clean.changes);
    design_.init_files = std::move(clean.init_files);
    checks_ = std::move(clean.checks);
    included_ = std::move(clean.included);
}

const Design& Builder::examine() {
    if (examined_) return design_;
    try {
        read_and_elaborate();
    } catch (ProjectError& error) {
        if (error.notes.empty()) error.notes = design_.project.notes;
        throw;
    }
    examined_ = true;
    return design_;
}

void Builder::read_and_elaborate() {
    design_.project = read_project(request_);
    folder_ = place_for(design_.project.folder);
    prepare_folder();
    entities_ = generic_entities(design_.project);
    for (const GenericEntity& entity : entities_)
        if (entity.name == design_.project.top)
            design_.project.parameters = entity.with_its_names(design_.project.parameters);
    elaborate();
    // Each round finds generics that the entities of the round before set in turn.
    for (bool is_new = true; is_new;) {
        is_new = false;
        for (GenericEntity& entity : entities_)
            if (entity.is_set) is_new |= entity.add(parameters_of(tree(), entity.name));
        if (is_new) elaborate();
    }
    read_tree();
    design_.binding =
        sim::project::bind(design_.elaborated.ports, design_.project.pins, design_.project.board);
    add_board_clocks(design_.project.board, design_.elaborated, design_.binding);
    if (design_.elaborated.pll_clocks.size() > 64)
        throw ProjectError{fmt::format("the design has {} PLL clocks, expected at most 64",
                                       design_.elaborated.pll_clocks.size())};
    check();
    check_init_files(design_.init_files, init_folders(design_.project));
    generate();
}

void Builder::read_tree() {
    design_.elaborated = read_elaborated(tree(), design_.project.top);
    for (const InitFile& file : design_.elaborated.init_files) design_.init_files.push_back(file);
}

void Builder::check() {
    const auto look = [this] {
        return check_design({design_.project, tree().string(), verilator_output_, checks_,
                             design_.elaborated.ports});
    };
    const auto has_two_drivers = [](const Message& m) { return m.number == 12014; };
    Checked checked = look();
    if (std::any_of(checked.errors.begin(), checked.errors.end(), has_two_drivers) &&
        fit_outputs()) {
        elaborate();
        read_tree();
        checked = look();
    }
    design_.warnings = std::move(checked.warnings);
    design_.self_reading = std::move(checked.self_reading);
    refuse(checked.errors);
}

// ProjectError: the first thing that Quartus refuses; the others are among the notes.
void Builder::refuse(const Messages& errors) const {
    if (errors.empty()) return;
    const auto text = [](const Message& m) {
        return m.number ? fmt::format("{}: Quartus error {}: {}", m.place(), m.number, m.text)
                        : fmt::format("{}: Quartus refuses this: {}", m.place(), m.text);
    };
    ProjectError error{text(errors.front())};
    error.notes = design_.project.notes;
    for (std::size_t n = 1; n < errors.size(); ++n) error.notes.push_back(text(errors[n]));
    throw error;
}

void Builder::generate() {
    write_if_new(folder_ / "de1sim_ports.vh", chip_ports_text());
    write_if_new(folder_ / "de1sim_wires.vh", chip_wires_text(design_.binding.header_outputs));
    write_if_new(folder_ / "de1sim_design.vh",
                 design_text(design_.binding, design_.project.top,
                             instance_text(design_.project.parameters)));
    write_if_new(folder_ / "de1sim_pll_taps.v", tap_text(design_.elaborated, design_.binding));
    write_if_new(folder_ / "de1sim_facts.h",
                 facts_text(design_.project, design_.elaborated, design_.binding));
}

std::string Builder::key() const {
    std::string more = fmt::format("{} {}\n", trace_, design_.project.top) +
                       state_of(runtime_library(verilator_, limit_));
    for (const char* name : {"de1sim_ports.vh", "de1sim_wires.vh", "de1sim_design.vh",
                             "de1sim_pll_taps.v", "de1sim_facts.h"})
        more += text_of(folder_ / name);
    return key_of(verilator_command(design_.project, includes_), more);
}

// Of all that a command of Verilator reads: the design, our own models, and the programs.
std::string Builder::key_of(const std::vector<std::string>& command, std::string all) const {
    all += state_of("/proc/self/exe") + verilator_.version + "\n";
    for (const char* name : {"project", "rtl/ip"}) {
        const FileFinder ours{data_folder() / name};
        for (const fs::path& file : ours.files()) all += text_of(file);
    }
    for (const auto& word : command) all += word + "\n";
    for (const fs::path& file : files_) all += text_of(folder_ / file);
    all += included_;
    return hash_of(all);
}

// An array that is assigned in a loop needs the loop unrolled, which is not done by itself where it
// has many rounds.
std::string Builder::translate(std::vector<std::string> command) const {
    try {
        return run_tool(command, folder_, limit_);
    } catch (const ProjectError& error) {
        if (std::string_view{error.what()}.find("inside for loops") == std::string_view::npos)
            throw;
    }
    command.insert(command.begin() + 1, {"--unroll-count", "5000", "--unroll-stmts", "1000000"});
    return run_tool(command, folder_, limit_);
}

Built Builder::build(const Progress& progress) {
    examine();
    const std::string name = fmt::format("chip-{}{}.so", key(), trace_ ? "-trace" : "");
    const fs::path library = folder_ / name;
    std::error_code error;
    if (fs::is_regular_file(library, error))
        return {library, true, design_.project.board, design_.project.systems};

    const fs::path objects = folder_ / (trace_ ? "objects-trace" : "objects");
    fs::remove_all(objects, error);
    fs::create_directories(objects);
    progress(fmt::format("translating {} (Verilator)", design_.project.top));
    auto command = verilator_command(design_.project, includes_);
    command.insert(command.end(),
                   {"--cc", "-O3", "--noassert", "--prefix", "Vde1sim_chip", "--Mdir",
                    objects.filename().string(), "--top-module", "de1sim_chip", "-I."});
    command.push_back("-Wwarn-UNOPTFLAT");  // for loops_text()
    if (trace_) command.insert(command.end(), {"--trace-fst", "-DDE1SIM_TRACE"});
    command.push_back("data/project/de1sim_chip.v");
    command.push_back("data/project/de1sim_clock_pulse.v");
    command.push_back("de1sim_pll_taps.v");
    for (const fs::path& file : files_) command.push_back(file.string());
    write_whole_file(objects / "de1sim_loops.h",
                     loops_text(translate(command), design_.self_reading));

    refuse_foreign_functions(objects);
    progress("compiling");
    compile_library(folder_, objects, trace_, verilator_, limit_);
    // Those of other states of the design are of no use any more.
    for (const auto& entry : fs::directory_iterator{folder_}) {
        const std::string old = entry.path().filename().string();
        if (old.compare(0, 5, "chip-") == 0 && (old.find("-trace") != std::string::npos) == trace_)
            fs::remove(entry.path(), error);
    }
    fs::rename(objects / "chip.so", library);
    return {library, false, design_.project.board, design_.project.systems};
}

}  // namespace sim::project
