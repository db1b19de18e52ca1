// platform_components.h - what describes the components of a project's Platform Designer systems
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/project/module_files.h"
#include "sim/project/qsys/component.h"
#include "sim/project/qsys/system.h"

namespace sim::project {

class PlatformComponents {
public:
    // `notes` gets what a person should know, a line each.
    PlatformComponents(ModuleFiles& files, std::vector<std::string>& notes)
        : files_{files}, notes_{notes} {}

    // The _hw.tcl of a kind: ours (rtl/ip/qsys), else one of the project's that gives itself this
    // name, also beside a file of the project's elsewhere or in a folder `ip` beside the project's,
    // else one whose file has it.  Nothing: there is none.
    std::optional<std::filesystem::path> hw_tcl(const std::string& kind);

    // By its _hw.tcl; else by SYSTEM.sopcinfo, with the module of this name or of these ports; else
    // by the ports of the module of this name, which is noted.  Nothing: none of them is there.
    // Where its files do not have the module that a _hw.tcl names, it is the one of its top file.
    std::optional<qsys::Component> describe(const qsys::System& system,
                                            const qsys::Instance& instance,
                                            const qsys::Parameters& parameters);

private:
    void find_names();
    const ModuleText* module_named(const std::string& kind);
    const ModuleText* module_with_ports(const qsys::Component& component,
                                        const qsys::Instance& instance) const;
    void find_module(qsys::Component& component);

    ModuleFiles& files_;
    std::vector<std::string>& notes_;
    std::optional<std::map<std::string, std::filesystem::path>> by_name_;  // the project's _hw.tcl
};

}  // namespace sim::project
