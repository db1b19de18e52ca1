#include "sim/linux/own_files.h"

#include <sys/stat.h>

#include <deque>
#include <utility>

namespace sim {

namespace {

class Folder final : public LinuxDevice {
public:
    Folder(std::string path, Entries entries)
        : path_{std::move(path)}, entries_{std::move(entries)} {}
    FileStatus status() const override { return status_of_own_folder(); }
    std::string name() const override { return path_; }
    std::int64_t read(void*, std::size_t) override { return -EISDIR; }
    const Entries* entries() const override { return &entries_; }

private:
    const std::string path_;
    const Entries entries_;
};

class Link final : public LinuxDevice {
public:
    Link(std::string path, const FileStatus& status) : path_{std::move(path)}, status_{status} {}
    FileStatus status() const override { return status_; }
    std::string name() const override { return path_; }
    std::int64_t read(void*, std::size_t) override { return -EBADF; }
    std::int64_t write(const void*, std::size_t) override { return -EBADF; }

private:
    const std::string path_;
    const FileStatus status_;
};

void put_names_in_front(std::deque<std::string>& names, const std::string& path) {
    std::deque<std::string> all;
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        if (end > begin) all.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    names.insert(names.begin(), all.begin(), all.end());
}

}  // namespace

FileStatus status_of_own_folder() { return {S_IFDIR | 0755, 0, 1, 0}; }

FileStatus OwnFiles::status_of_link(const std::string& path) const {
    return {S_IFLNK | 0777, target_of(path).value_or("").size()};
}

std::shared_ptr<LinuxDevice> OwnFiles::open_link(const std::string& path) const {
    return std::make_shared<Link>(path, status_of_link(path));
}

std::optional<std::string> OwnFiles::resolve(const std::string& path, Last last) const {
    constexpr unsigned MOST_LINKS = 40;
    std::deque<std::string> names;
    put_names_in_front(names, path);
    std::string way;
    for (unsigned links = 0; !names.empty();) {
        const std::string name = std::move(names.front());
        names.pop_front();
        if (name == ".") continue;
        if (name == "..") {
            way.resize(way.empty() ? 0 : way.rfind('/'));
            continue;
        }
        const auto target = target_of(way + "/" + name);
        if (!target || (names.empty() && last == Last::KEEP)) {
            way += "/" + name;
            continue;
        }
        if (++links > MOST_LINKS) return std::nullopt;
        if (target->front() == '/') way.clear();
        put_names_in_front(names, *target);
    }
    return way;
}

std::optional<int> OwnFiles::open_file(const std::string& path, int process) const {
    const std::string folder = "/proc/" + std::to_string(process) + "/fd/";
    std::optional<std::string> at = resolve(path, Last::KEEP);
    for (unsigned links = 0; at && links < 3; ++links) {
        const auto target = target_of(*at);
        if (target && at->rfind(folder, 0) == 0) return std::stoi(at->substr(folder.size()));
        at = target && target->front() == '/' ? resolve(*target, Last::KEEP) : std::nullopt;
    }
    return std::nullopt;
}

bool OwnFiles::is_folder(const std::string& path) const {
    const std::string inside = path + "/";
    const auto next = files_.lower_bound(inside);
    return next != files_.end() && next->first.rfind(inside, 0) == 0;
}

std::optional<std::string> OwnFiles::target_of(const std::string& path) const {
    const auto found = files_.find(path);
    return found == files_.end() ? std::nullopt : found->second.target;
}

std::optional<std::string> OwnFiles::text_of(const std::string& path) const {
    const auto found = files_.find(path);
    return found == files_.end() ? std::nullopt : found->second.text;
}

LinuxDevice::Entries OwnFiles::entries(const std::string& folder) const {
    LinuxDevice::Entries all{{".", S_IFDIR}, {"..", S_IFDIR}};
    const std::string inside = folder + "/";
    for (auto at = files_.lower_bound(inside);
         at != files_.end() && at->first.rfind(inside, 0) == 0; ++at) {
        const std::string rest = at->first.substr(inside.size());
        const std::size_t slash = rest.find('/');
        if (slash != std::string::npos)
            all.insert_or_assign(rest.substr(0, slash), S_IFDIR);
        else
            all.emplace(rest, at->second.target ? S_IFLNK : 0);
    }
    return all;
}

std::shared_ptr<LinuxDevice> OwnFiles::folder(std::string path, LinuxDevice::Entries entries) {
    return std::make_shared<Folder>(std::move(path), std::move(entries));
}

}  // namespace sim
