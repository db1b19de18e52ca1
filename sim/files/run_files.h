// run_files.h - the names that a run writes in its output folder, as Patterns.
#pragma once

namespace sim {

constexpr const char* RUN_FILES = R"(audio(-[0-9]+)?\.wav|report\.json|junit\.xml|console\.txt)";
constexpr const char* FRAME_FILES = R"(frame_[0-9]{6,}\.png)";  // in frames/
constexpr const char* MISMATCH_FILES =
    R"(line[0-9]+_.*_(actual|expected|difference)\.png)";  // mismatch/

// Names that no other file in the folder may have: those of the files, also while they are written,
// and of the two folders.
constexpr const char* RUN_NAMES =
    R"((audio(-[0-9]+)?\.wav|report\.json|junit\.xml|console\.txt)(\.part)?|frames|mismatch)";

}  // namespace sim
