// output_folder.h - the folder that a run writes into, and that no other run may meanwhile.
//
// The lock is the kernel's, on the folder itself: nothing of it is seen in the folder, and it ends
// with the process, however that ends.
//
// Not handled: file systems without locks (some network ones).  Two runs can meet there.
#pragma once

#include <filesystem>

namespace sim {

class OutputFolder {
public:
    // Makes the folder, locks it, and removes what an earlier run left in it under the names of
    // this one's files.  IoError, also where another run holds it: then nothing is touched.
    explicit OutputFolder(std::filesystem::path path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    void lock();

    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace sim
