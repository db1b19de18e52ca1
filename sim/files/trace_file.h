// trace_file.h - an FST file written by another library; it appears complete or not at all.
//
// GTKWave's FST writer reports no error.  On a full disk it truncates its file silently, or raises
// SIGBUS in a temporary file that it has mapped.  So the file is checked before it appears, and
// SIGBUS ends the program with the same message and exit code as any other full disk.
#pragma once

#include <filesystem>
#include <string>

#include "sim/files/whole_file.h"

namespace sim {

// The file's bytes as a packed FST: one block, which holds them as gzip packs them.  GTKWave's
// tools read it, at half the size and less.
std::string packed_fst(const std::string& bytes);

// True if the file consists of complete blocks, among them a header, a geometry and a hierarchy.
// Reads only the head of each block.
bool is_whole_fst(const std::filesystem::path& path);

// One at a time: SIGBUS has one handler.
class TraceFile {
public:
    explicit TraceFile(const std::filesystem::path& path);  // IoError if it cannot be created
    ~TraceFile();

    const std::filesystem::path& part() const { return file_.part(); }  // to be written here

    // Once its writer has closed it: IoError if incomplete.  `packed`: unless it is larger than
    // 256 MiB.
    void commit(bool packed = false);

private:
    WholeFile file_;
};

}  // namespace sim
