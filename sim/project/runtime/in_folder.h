// in_folder.h - the working directory, for as long as it lives, also where what it calls throws
#pragma once

#include <filesystem>
#include <system_error>

namespace sim::project {

class InFolder {
public:
    explicit InFolder(const char* folder) : here_{std::filesystem::current_path()} {
        std::filesystem::current_path(folder);
    }
    ~InFolder() {
        std::error_code error;
        std::filesystem::current_path(here_, error);
    }

private:
    const std::filesystem::path here_;
};

}  // namespace sim::project
