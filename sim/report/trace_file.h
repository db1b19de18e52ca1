// trace_file.h - an FST file that another library writes: it appears whole or not at all.
//
// GTKWave's FST writer reports no error.  On a full disk it cuts its file short without a word, or
// dies by SIGBUS in a temporary file that it has mapped.  So the file is checked before it appears,
// and SIGBUS ends the program with the line and the exit code of any other full disk.
#pragma once

#include <filesystem>

#include "sim/report/whole_file.h"

namespace sim {

// Is it blocks from end to end, with a header, a geometry and a hierarchy among them?  Reads the
// head of each block only.
bool is_whole_fst(const std::filesystem::path& path);

// One at a time: SIGBUS has one handler.
class TraceFile {
public:
    explicit TraceFile(const std::filesystem::path& path);  // IoError if it cannot be created
    ~TraceFile();

    const std::filesystem::path& part() const { return file_.part(); }  // to be written here

    void commit();  // once its writer has closed it: IoError if it is not whole

private:
    WholeFile file_;
};

}  // namespace sim
