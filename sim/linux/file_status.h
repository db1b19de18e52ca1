// file_status.h - what stat() says of a Linux program's file.
#pragma once

#include <cstdint>

namespace sim {

struct FileStatus {
    std::uint32_t mode = 0;  // type and permissions
    std::uint64_t size = 0, number = 0, device = 0;
};

}  // namespace sim
