// build.h - from a project to a library that can be loaded: `de1sim build`, `de1sim check`.
#pragma once

#include <functional>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "sim/project/binding.h"
#include "sim/project/folder_lock.h"
#include "sim/project/project.h"
#include "sim/project/quartus/check.h"
#include "sim/project/tools.h"
#include "sim/project/verilator.h"
#include "sim/verilog/inout_fits.h"
#include "sim/verilog/part_drivers.h"
#include "sim/vhdl/vhdl_generics.h"

namespace sim::project {

struct Design {
    Project project;
    Elaborated elaborated;
    Binding binding;
    std::vector<std::string> changes;  // by the normaliser
    Messages warnings;                 // as Quartus would give, sorted
    std::string self_reading;          // what has no register and reads itself: "q (ring.v:7)"
    std::vector<InitFile> init_files;  // of the design's own memories, and of its IP
};

struct Built {
    std::filesystem::path library;
    bool was_up_to_date;
    BoardDescription board;
    std::vector<qsys::Generated> systems;
};

// What is text while it goes on: "translating 12 files (Verilator)".
using Progress = std::function<void(const std::string& line)>;

class Builder {
public:
    // `trace`: with waveforms, which is another library.  ProjectError.
    Builder(const Request& request, bool trace);

    // Reads and elaborates the design, without compiling it.  ProjectError: a module is missing, a
    // file has an error, with the place.
    const Design& examine();

    // Compiles it, unless that has been done with the same files, options and tools.  ProjectError;
    // what is half built is never used.
    Built build(const Progress& progress);

private:
    void read_and_elaborate();
    void prepare_folder();
    void read_clean_sources();
    bool fit_inout(const std::string& error);
    bool fit_outputs();
    bool add_fit(const std::smatch& said);
    std::string translate(std::vector<std::string> command) const;
    void check();
    void refuse(const Messages& errors) const;
    void elaborate();
    void read_tree();
    bool write_tree();
    bool mend(const std::string& said);
    std::filesystem::path tree() const;
    void generate();
    std::string key() const;
    std::string key_of(const std::vector<std::string>& command, std::string more = {}) const;

    FolderLock lock_;  // from examine() on: two runs of one project do not build at once
    Request request_;
    Verilator verilator_;
    bool trace_;
    const TimeLimit limit_;
    Design design_;
    std::filesystem::path folder_;       // .de1sim beside the project, or in the user's cache
    std::vector<std::string> includes_;  // names in folder_ of the folders of headers
    std::string included_;               // the texts of all headers
    std::vector<std::filesystem::path> files_;                 // cleaned copies, in folder_
    std::vector<GenericEntity> entities_;                      // in VHDL
    std::map<std::string, TextChecks> checks_;                 // by file
    std::map<std::string, std::vector<InoutFit>> inout_fits_;  // by file
    std::string verilator_output_;  // by Verilator of the last elaboration
    unsigned elaborations_ = 0;     // so far, each with a tree and Verilator's answer of its own
    bool as_json_ = false;          // it cannot write XML
    bool examined_ = false;
};

}  // namespace sim::project
