#include "sim/chip/project_chip.h"

#include <dlfcn.h>

#include <stdexcept>

#include "sim/project/runtime/analog.h"
#include "sim/text/messages.h"

namespace sim {

void ProjectDesign::Unload::operator()(void* library) const { dlclose(library); }

ProjectDesign::ProjectDesign(PinListener& pins, const std::filesystem::path& library,
                             const std::string& folder, const Trace& trace,
                             project::JtagTerminals* terminals, project::ProcessorMemory* memory)
    : library_{dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL)} {
    if (!library_) throw std::runtime_error{std::string{"cannot load the design: "} + dlerror()};
    const auto open =
        reinterpret_cast<project::OpenModel*>(dlsym(library_.get(), "de1sim_open_model"));
    if (!open) throw std::runtime_error{library.string() + ": is not a design that was built here"};
    if (const auto set_analog = reinterpret_cast<decltype(&de1sim_set_analog)>(
            dlsym(library_.get(), "de1sim_set_analog")))
        set_analog(&pins);
    model_.reset(open(pins, {folder.c_str(), trace, [](const char* line) { complain(line); },
                             terminals, memory}));
}

std::optional<Chip::End> ProjectDesign::end() const {
    using End = Chip::End;
    using Kind = FpgaModel::Ending::Kind;
    const FpgaModel::Ending ending = model_->ending();
    switch (ending.kind) {
        case Kind::NONE: return {};
        case Kind::FINISHED: return End{End::Kind::FINISHED, ending.message};
        case Kind::STOPPED: return End{End::Kind::FAILED, ending.message};
        case Kind::DIVERGED: break;
    }
    return End{End::Kind::BROKEN, ending.message};
}

}  // namespace sim
