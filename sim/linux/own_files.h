// own_files.h - the kernel's own files at a moment: which there are, and what is in a folder.
//
// The kernel enters the paths of all of them, and a folder is what lies above one.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "sim/linux/device.h"

namespace sim {

class OwnFiles {
public:
    void add(const std::string& path) { files_.emplace(path, File{}); }
    void add_folder(const std::string& path) { add(path + "/."); }  // that may be empty
    void add_text(const std::string& path, const std::string& text) { files_[path].text = text; }
    // A symbolic link; relative targets begin at its folder.
    void add_link(const std::string& path, const std::string& to) { files_[path].target = to; }

    // Without ".", "..", double slashes and links; KEEP: but for a link at its end.  Nothing has to
    // be there.  "" for the root; no value for a ring of links.
    enum class Last { FOLLOW, KEEP };
    std::optional<std::string> resolve(const std::string& path, Last last) const;

    // The open file of `process` to which this path leads: /proc/PROCESS/fd/NUMBER, /dev/stdin.
    std::optional<int> open_file(const std::string& path, int process) const;

    // Of paths that are resolved.
    bool is_folder(const std::string& path) const;
    std::optional<std::string> target_of(const std::string& path) const;
    std::optional<std::string> text_of(const std::string& path) const;
    // An open folder, with the kinds of its files as `status` has them.
    template <class Status>
    std::shared_ptr<LinuxDevice> open_folder(const std::string& path, Status status) const;
    // Of a link itself: its status, and by O_PATH, open, nothing but that.
    FileStatus status_of_link(const std::string& path) const;
    std::shared_ptr<LinuxDevice> open_link(const std::string& path) const;

private:
    LinuxDevice::Entries entries(const std::string& folder) const;
    static std::shared_ptr<LinuxDevice> folder(std::string path, LinuxDevice::Entries entries);

    struct File {
        std::optional<std::string> target = {}, text = {};
    };
    std::map<std::string, File> files_;  // by path
};

FileStatus status_of_own_folder();

template <class Status>
std::shared_ptr<LinuxDevice> OwnFiles::open_folder(const std::string& path, Status status) const {
    LinuxDevice::Entries all = entries(path);
    for (auto& [name, mode] : all)
        if (mode == 0)
            if (const std::optional<FileStatus> found = status(path + "/" + name))
                mode = found->mode;
    return folder(path, std::move(all));
}

}  // namespace sim
