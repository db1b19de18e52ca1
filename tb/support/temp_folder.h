// temp_folder.h - an empty folder for one test, gone after it
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

class TempFolder {
public:
    TempFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "de1sim.XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::filesystem::filesystem_error("mkdtemp", {});
        path_ = name;
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    void put(const std::string& name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
    }
    std::string get(const std::string& name) const {
        std::ifstream in(path_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    // What is in there, without "." and "..".
    std::size_t count() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::recursive_directory_iterator(path_), {}));
    }

private:
    std::filesystem::path path_;
};

// What a shell command prints, and "exit N" after it if it fails.
inline std::string output_of(const std::string& command) {
    std::string out;
    std::FILE* pipe = popen(command.c_str(), "r");
    for (int c; (c = std::fgetc(pipe)) != EOF;) out += static_cast<char>(c);
    const int status = pclose(pipe);
    return status == 0 ? out : out + "exit " + std::to_string(status >> 8);
}
