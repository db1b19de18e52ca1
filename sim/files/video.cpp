// video.cpp - loads the module
#include "sim/files/video.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

#include "sim/files/whole_file.h"

namespace sim {

namespace {

namespace fs = std::filesystem;

constexpr const char* MODULE = "de1sim-video.so";

// Beside libde1sim.so for a program that was linked with it, else as the program is installed.
fs::path module_path() {
    Dl_info self{};
    if (dladdr(reinterpret_cast<void*>(&module_path), &self) != 0) {
        const fs::path beside = fs::path{self.dli_fname}.parent_path() / MODULE;
        if (fs::exists(beside)) return beside;
    }
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return program.parent_path().parent_path() / LIBRARY_FOLDER / MODULE;
}

}  // namespace

bool is_video_name(const fs::path& path) {
    return path.extension() == ".mp4" || path.extension() == ".webm";
}

std::unique_ptr<VideoWriter> open_video(const fs::path& path) {
    const fs::path module = module_path();
    if (!fs::exists(module))
        throw std::runtime_error{"--video: de1sim was built without FFmpeg's libraries"};
    void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::runtime_error{std::string{"--video: "} + dlerror()};
    const auto open =
        reinterpret_cast<decltype(&de1sim_open_video)>(dlsym(library, "de1sim_open_video"));
    if (!open) throw std::runtime_error{std::string{"--video: "} + dlerror()};
    remove_with_open_parts(path.string() + ".part");
    return std::unique_ptr<VideoWriter>{open(path)};
}

}  // namespace sim
