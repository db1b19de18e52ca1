#include "sim/verilog/unsupported.h"

#include <map>
#include <set>

#include "sim/text/lower.h"

namespace sim::project {

namespace {

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

}  // namespace

const char ENCRYPTED[] =
    "is encrypted, so it cannot be simulated, expected Verilog that can be read";

std::optional<std::string> unsupported_file(const std::filesystem::path& file) {
    static const char SOPC[] =
        "a system of SOPC Builder cannot be simulated: Platform Designer makes a .qsys of it";
    static const char SCHEMATIC[] =
        "a schematic cannot be simulated: save it as Verilog in Quartus (File, Create HDL Design "
        "File)";
    static const char NETLIST[] = "a netlist of cells cannot be simulated, expected its sources";
    static const std::map<std::string, const char*> BY_ENDING{
        {".sopc", SOPC},
        {".bdf", SCHEMATIC},
        {".gdf", SCHEMATIC},
        {".tdf", "AHDL cannot be simulated, expected Verilog"},
        {".smf", "a diagram of states cannot be simulated: generate Verilog from it in Quartus"},
        {".edf", NETLIST},
        {".edif", NETLIST},
        {".vqm", NETLIST},
        {".qxp", NETLIST}};
    const auto found = BY_ENDING.find(lower(file.extension().string()));
    if (found == BY_ENDING.end()) return {};
    return found->second;
}

std::optional<std::string> unsupported_module(const std::string& name) {
    const std::string low = lower(name);
    if (low.compare(0, 12, "cyclonev_hps") == 0 || has(low, "hps_io") || has(low, "altera_hps") ||
        has(low, "hps_fpga_interfaces") || has(low, "hps_sdram"))
        return "this part of the processor (HPS) cannot be simulated";
    if (has(low, "nios2") || has(low, "nios_ii") || low == "nios")
        return "a Nios processor cannot be simulated";
    if (low == "fiftyfivenm_adcblock" || low.compare(0, 18, "altera_modular_adc") == 0)
        return "the AD converter in a MAX 10 cannot be simulated";
    return {};
}

bool is_simulation_library(const std::filesystem::path& file) {
    static const std::set<std::string> NAMES{"220model",
                                             "220pack",
                                             "altera_lnsim",
                                             "altera_lnsim_components",
                                             "altera_mf",
                                             "altera_mf_components",
                                             "altera_primitives",
                                             "altera_primitives_components",
                                             "cyclonev_atoms",
                                             "cyclonev_atoms_ncrypt",
                                             "cyclonev_hssi_atoms",
                                             "cyclonev_components",
                                             "sgate",
                                             "sgate_pack"};
    return NAMES.count(lower(file.stem().string())) > 0;
}

bool is_encrypted(const std::filesystem::path& file, std::string_view text) {
    const std::string ending = lower(file.extension().string());
    if (text.substr(0, 4) == "\x8B\x13\x9C\x2F")  // as Quartus' own IP is
        return ending != ".ocp";                  // which says who may have it
    return ending == ".vp" || ending == ".svp" || has(text, "`pragma protect begin") ||
           has(text, "`protected\n") || has(text, "`protected\r");
}

}  // namespace sim::project
