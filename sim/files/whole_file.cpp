// whole_file.cpp - temporary file, then rename
#include "sim/files/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "sim/text/printable.h"

namespace sim {

namespace {

// Not strerror(), which is not thread-safe.
std::string reason(int error_number) {
    return std::error_code(error_number, std::generic_category()).message();
}

// A signal's handler can neither allocate nor wait for a lock.
struct OpenPart {
    enum State { FREE, CHANGES, OPEN };
    std::atomic<State> state{FREE};
    char name[4096];
};
constexpr unsigned MOST_OPEN = 16, NOWHERE = MOST_OPEN;
OpenPart open_parts[MOST_OPEN];

unsigned enlist(const std::string& name) {
    for (unsigned place = 0; place < MOST_OPEN && name.size() < sizeof OpenPart::name; ++place) {
        OpenPart::State expected = OpenPart::FREE;
        OpenPart& part = open_parts[place];
        if (!part.state.compare_exchange_strong(expected, OpenPart::CHANGES)) continue;
        name.copy(part.name, name.size());
        part.name[name.size()] = '\0';
        part.state = OpenPart::OPEN;
        return place;
    }
    return NOWHERE;
}

void strike_out(unsigned& place) {
    if (place != NOWHERE) open_parts[place].state = OpenPart::FREE;
    place = NOWHERE;
}

}  // namespace

void remove_open_parts() {
    for (const OpenPart& part : open_parts)
        if (part.state == OpenPart::OPEN) ::unlink(part.name);
}

IoError::IoError(std::filesystem::path path, std::string problem)
    : std::runtime_error(printable(path.string()) + ": " + problem),
      path_(std::move(path)),
      problem_(std::move(problem)) {}

IoError::IoError(std::filesystem::path path, const std::string& doing, int error_number)
    : IoError(std::move(path), doing == "read" && error_number == ENOENT
                                   ? "is not there"
                                   : "cannot " + doing + ": " + reason(error_number)) {}

WholeFile::WholeFile(std::filesystem::path path) : path_(std::move(path)), part_(path_) {
    part_ += ".part";
    descriptor_ = ::open(part_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) throw IoError(path_, "create", errno);
    place_ = enlist(part_.string());
}

WholeFile::~WholeFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!part_.empty()) ::unlink(part_.c_str());
    strike_out(place_);
}

void WholeFile::write(const void* bytes, std::size_t size) {
    const char* next = static_cast<const char*>(bytes);
    while (size > 0) {
        const ssize_t written = ::write(descriptor_, next, size);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw IoError(path_, "write", errno);
        next += written;
        size -= static_cast<std::size_t>(written);
    }
}

void WholeFile::commit() {
    if (::close(std::exchange(descriptor_, -1)) != 0) throw IoError(path_, "write", errno);
    if (std::rename(part_.c_str(), path_.c_str()) != 0) throw IoError(path_, "create", errno);
    part_.clear();
    strike_out(place_);
}

void write_whole_file(const std::filesystem::path& path, const void* bytes, std::size_t size) {
    WholeFile file(path);
    file.write(bytes, size);
    file.commit();
}

void write_whole_file(const std::filesystem::path& path, std::string_view text) {
    write_whole_file(path, text.data(), text.size());
}

void make_folder(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw IoError(path, "create the folder", error.value());
}

std::string read_whole_file(const std::filesystem::path& path, std::size_t max_bytes) {
    std::error_code error;
    const auto kind = std::filesystem::status(path, error).type();
    if (kind == std::filesystem::file_type::directory) throw IoError(path, "is a folder");
    if (error) throw IoError(path, "read", error.value());
    if (kind != std::filesystem::file_type::regular) throw IoError(path, "is not a file");

    const auto size = std::filesystem::file_size(path, error);
    if (error) throw IoError(path, "read", error.value());
    if (size > max_bytes)
        throw IoError(path, "is larger than " + std::to_string(max_bytes) + " bytes");
    std::FILE* file = std::fopen(path.c_str(), "rbe");
    if (!file) throw IoError(path, "read", errno);
    std::string bytes(size, '\0');
    bytes.resize(std::fread(bytes.data(), 1, size, file));
    const int problem = std::ferror(file) ? errno : 0;
    std::fclose(file);
    if (problem) throw IoError(path, "read", problem);
    return bytes;
}

}  // namespace sim
