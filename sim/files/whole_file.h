// whole_file.h - files that appear complete or not at all
//
// The bytes go into NAME.part in the same folder; commit() renames it to NAME.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sim {

// what() is "out/report.json: cannot write: No space left on device".
class IoError : public std::runtime_error {
public:
    IoError(std::filesystem::path path, std::string problem);
    IoError(std::filesystem::path path, const std::string& doing, int error_number);

    const std::filesystem::path& path() const { return path_; }
    const std::string& problem() const { return problem_; }  // what() without the path

private:
    std::filesystem::path path_;
    std::string problem_;
};

// Every failure throws IoError.  Destruction without commit() removes the temporary file.
class WholeFile {
public:
    explicit WholeFile(std::filesystem::path path);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    void write(const void* bytes, std::size_t size);
    void commit();

    // For a library that writes by itself; it must not close it.
    int descriptor() const { return descriptor_; }
    const std::filesystem::path& path() const { return path_; }
    const std::filesystem::path& part() const { return part_; }

private:
    std::filesystem::path path_;
    std::filesystem::path part_;
    int descriptor_;
    unsigned place_;  // in the list for remove_open_parts()
};

// Removes the temporary files of all that are open: for a signal's handler that ends the program.
// Those beyond the sixteenth, or with names of over 4,095 bytes, stay.
void remove_open_parts();

void write_whole_file(const std::filesystem::path& path, const void* bytes, std::size_t size);
void write_whole_file(const std::filesystem::path& path, std::string_view text);

// With parents; one that exists is fine.
void make_folder(const std::filesystem::path& path);

// The bytes of a regular file of at most `max_bytes`; anything else is an IoError.  Opens nothing
// but regular files: a pipe would block for ever.
std::string read_whole_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace sim
