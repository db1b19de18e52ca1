// init_checks.h - the files that memories begin with, read before the design runs.
#pragma once

#include <string>
#include <vector>

#include "sim/project/elaborated.h"
#include "sim/project/init_file.h"
#include "sim/project/project.h"

namespace sim::project {

InitFolders init_folders(const Project& project);

// ProjectError: one that is there is broken: "font.mif:3: ..., expected ..., as the initial words
// of the memory at rom.v:12".
void check_init_files(const std::vector<InitFile>& files, const InitFolders& folders);

// The words of a MIF or an Intel HEX file as bits, 0101; none: it is nowhere, or its words' width
// is not known.  `width` is 0 where only the file says it.  ProjectError, as above.
std::vector<std::string> initial_words(const InitFile& wanted, const InitFolders& folders,
                                       unsigned width);

}  // namespace sim::project
