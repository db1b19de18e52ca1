#include "sim/chip/project_chip.h"

#include <dlfcn.h>

#include <stdexcept>

#include "sim/report/messages.h"

namespace sim {

namespace {

const sc_core::sc_time batch{32, sc_core::SC_US};

}  // namespace

void ProjectChip::Unload::operator()(void* library) const { dlclose(library); }

ProjectChip::ProjectChip(const sc_core::sc_module_name& name, PinListener& pins,
                         const std::filesystem::path& library, const std::string& folder,
                         const Trace& trace)
    : sc_module{name}, library_{dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL)} {
    if (!library_) throw std::runtime_error{std::string{"cannot load the design: "} + dlerror()};
    const auto open =
        reinterpret_cast<project::OpenModel*>(dlsym(library_.get(), "de1sim_open_model"));
    if (!open) throw std::runtime_error{library.string() + ": is not a design that was built here"};
    model_.reset(open(pins, {folder.c_str(), trace, [](const char* line) { complain(line); }}));
    SC_HAS_PROCESS(ProjectChip);
    SC_METHOD(look);
    sensitive << look_;
}

ProjectChip::~ProjectChip() = default;

void ProjectChip::catch_up() {
    model_->run(time_ps_ = sc_core::sc_time_stamp().value());
    model_->flush();
}

std::optional<Chip::End> ProjectChip::end() const {
    using project::Ending;
    const Ending& ending = model_->ending();
    switch (ending.kind) {
        case Ending::Kind::NONE: return {};
        case Ending::Kind::FINISHED: return End{End::Kind::FINISHED, ending.message};
        case Ending::Kind::STOPPED: return End{End::Kind::FAILED, ending.message};
        case Ending::Kind::DIVERGED: break;
    }
    return End{End::Kind::BROKEN, ending.message};
}

void ProjectChip::look() {
    catch_up();
    look_.notify(batch);
}

}  // namespace sim
