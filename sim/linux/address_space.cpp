#include "sim/linux/address_space.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "sim/linux/bus_errors.h"

namespace sim {

namespace {

constexpr std::uint32_t STACK_ROOM = 0x09000000;  // kept free below TOP
constexpr std::size_t LONGEST_STRING = 4096;

std::uint64_t ram_of(std::uint32_t begin, const AddressSpace::Area& area) {
    const bool is_file = area.shared && area.shared->is_file();
    return area.on_bus || is_file || area.access == 0 ? 0 : area.end - begin;
}

// As the file is now, which may have become longer since is_beyond was found.
bool is_after_end(std::uint32_t begin, const AddressSpace::Area& area, std::uint32_t address) {
    return area.is_beyond &&
           area.physical_at(address - begin) / AddressSpace::PAGE >=
               (area.shared->size() + AddressSpace::PAGE - 1) / AddressSpace::PAGE;
}

bool is_connected(const AddressSpace::Area& area) { return area.access != 0 && !area.is_beyond; }

// Calls `each` with the offset of every page that may hold something.  The host knows which pages
// nobody has touched: they are zeros.
template <class Each>
void each_touched_page(const std::uint8_t* begin, std::size_t bytes, Each each) {
    static const int map = ::open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC);
    constexpr std::uint64_t PRESENT_OR_SWAPPED = std::uint64_t{3} << 62;
    const bool is_known = map >= 0 && sysconf(_SC_PAGESIZE) == AddressSpace::PAGE;
    std::array<std::uint64_t, 512> entries;
    for (std::size_t page = 0, count = bytes / AddressSpace::PAGE; page < count;) {
        const std::size_t some = std::min(entries.size(), count - page);
        const std::uint8_t* const at = begin + page * AddressSpace::PAGE;
        const auto offset = reinterpret_cast<std::uintptr_t>(at) / AddressSpace::PAGE * 8;
        const auto size = static_cast<ssize_t>(some * 8);
        const bool read =
            is_known && pread(map, entries.data(), some * 8, static_cast<off_t>(offset)) == size;
        for (std::size_t i = 0; i < some; ++i)
            if (!read || (entries[i] & PRESENT_OR_SWAPPED)) each((page + i) * AddressSpace::PAGE);
        page += some;
    }
}

// Whether the host would give so many bytes more.
bool host_has(std::size_t bytes) {
    void* const more = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return more != MAP_FAILED && munmap(more, bytes) == 0;
}

}  // namespace

AddressSpace::AddressSpace(ArmCore& core, std::uint32_t bottom, std::uint32_t top)
    : core_{core}, bottom_{bottom}, top_{top} {
    void* area =
        mmap(nullptr, top - bottom, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (area == MAP_FAILED) throw std::bad_alloc{};
    host_ = static_cast<std::uint8_t*>(area) - bottom;
}

AddressSpace::~AddressSpace() {
    all_ram_ -= own_ram_;
    all_areas_ -= areas_.size();
    if (has_files_) bus_errors::forget(host_ + bottom_);
    munmap(host_ + bottom_, top_ - bottom_);
}

// ---- The core's list ----------------------------------------------------------------------------

void AddressSpace::connect(Areas::const_iterator area) {
    const auto& [begin, what] = *area;
    if (!is_connected(what) || !attached_) return;
    if (what.on_bus)
        core_.map_bus(begin, what.end - begin, what.physical, what.access);
    else
        core_.map_ram(begin, what.end - begin, host_ + begin, what.access | arm_access::NORMAL);
}

void AddressSpace::disconnect(Areas::const_iterator area) {
    if (is_connected(area->second) && attached_)
        core_.unmap(area->first, area->second.end - area->first);
}

void AddressSpace::attach() {
    attached_ = true;
    for (auto area = areas_.begin(); area != areas_.end(); ++area) connect(area);
}

void AddressSpace::detach() {
    for (auto area = areas_.begin(); area != areas_.end(); ++area) disconnect(area);
    attached_ = false;
}

std::shared_ptr<AddressSpace> AddressSpace::copy() const {
    static const std::vector<std::uint8_t> zeros(PAGE);
    constexpr std::size_t RESERVE = 256 << 20;  // a translator without memory ends de1sim
    if (all_ram_ + own_ram_ > ALL_RAM || all_areas_ + areas_.size() + 2 > MOST_AREAS ||
        !host_has(RESERVE))
        return nullptr;
    auto other = std::make_shared<AddressSpace>(core_);
    for (const auto& [begin, area] : areas_) {
        const std::uint32_t bytes = area.end - begin;
        if (area.on_bus) {
            if (!other->map_bus(begin, bytes, area.access, area.physical)) return nullptr;
        } else if (area.shared) {
            if (!other->map_shared(begin, bytes, area.access, area.shared, area.physical))
                return nullptr;
        } else {
            if (!other->map(begin, bytes, 0)) return nullptr;  // the host has no more memory
            each_touched_page(host_ + begin, bytes, [&](std::size_t page) {
                std::uint8_t* const from = host_ + begin + page;
                if (std::memcmp(from, zeros.data(), PAGE) != 0)
                    std::memcpy(other->host_ + begin + page, from, PAGE);
            });
            other->protect(begin, bytes, area.access);
        }
    }
    return other;
}

// ---- RAM ----------------------------------------------------------------------------------------

void AddressSpace::count(std::uint32_t begin, const Area& area, bool more) {
    const std::uint64_t bytes = ram_of(begin, area);
    const auto add = [&](std::uint64_t& sum) { sum = more ? sum + bytes : sum - bytes; };
    add(ram_);
    if (area.shared) return;
    add(own_ram_);
    add(all_ram_);
}

bool AddressSpace::has_room(std::uint64_t bytes, bool shared) const {
    return ram_ + bytes <= RAM && (shared || all_ram_ + bytes <= ALL_RAM);
}

// ---- Areas --------------------------------------------------------------------------------------

AddressSpace::Areas::iterator AddressSpace::add(std::uint32_t begin, const Area& area) {
    ++all_areas_;
    return areas_.emplace(begin, area).first;
}

AddressSpace::Areas::iterator AddressSpace::remove(Areas::iterator area) {
    --all_areas_;
    return areas_.erase(area);
}

// Splits the area around `address` there.
void AddressSpace::split(std::uint32_t address) {
    auto area = areas_.upper_bound(address);
    if (area == areas_.begin()) return;
    --area;
    if (area->first == address || area->second.end <= address) return;
    disconnect(area);
    Area upper = area->second;
    upper.physical = upper.physical_at(address - area->first);
    area->second.end = address;
    connect(area);
    connect(add(address, upper));
}

// Joins it with the one after it, if both are alike.
void AddressSpace::join(Areas::iterator area) {
    const auto next = std::next(area);
    if (next == areas_.end() || next->first != area->second.end ||
        next->second.access != area->second.access || next->second.on_bus != area->second.on_bus ||
        next->second.shared != area->second.shared ||
        next->second.is_beyond != area->second.is_beyond ||
        next->second.physical != area->second.physical_at(area->second.end - area->first))
        return;
    disconnect(area);
    disconnect(next);
    area->second.end = next->second.end;
    remove(next);
    connect(area);
}

void AddressSpace::join_all(std::uint32_t begin, std::uint32_t end) {
    auto it = areas_.lower_bound(begin);
    if (it != areas_.begin()) --it;
    while (it != areas_.end() && it->first < end) {
        const std::size_t before = areas_.size();
        join(it);
        if (areas_.size() == before) ++it;
    }
}

void AddressSpace::insert(std::uint32_t begin, const Area& area) {
    const auto at = add(begin, area);
    connect(at);
    count(begin, area, true);
    join(at);
    if (at != areas_.begin()) join(std::prev(at));
}

bool AddressSpace::map(std::uint32_t begin, std::uint32_t bytes, unsigned access) {
    if (!has_areas() || bytes > RAM || (access != 0 && !has_room(bytes, false))) return false;
    unmap(begin, bytes);
    void* const fresh = mmap(host_ + begin, bytes, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED, -1, 0);
    if (fresh == MAP_FAILED) return false;
    insert(begin, {begin + bytes, access, false, 0, nullptr});
    return true;
}

bool AddressSpace::map_bus(std::uint32_t begin, std::uint32_t bytes, unsigned access,
                           std::uint32_t physical) {
    if (!has_areas()) return false;
    unmap(begin, bytes);
    insert(begin, {begin + bytes, access, true, physical, nullptr});
    return true;
}

bool AddressSpace::may_unmap(std::uint32_t begin, std::uint32_t bytes) const {
    const auto area = at(begin);
    const bool divides = area && area->first < begin && area->second.end - begin > bytes;
    return !divides || has_areas();
}

bool AddressSpace::map_shared(std::uint32_t begin, std::uint32_t bytes, unsigned access,
                              std::shared_ptr<SharedMemory> memory, std::uint32_t offset) {
    const bool is_file = memory->is_file();
    if (!has_areas() || (!is_file && !has_room(bytes, true)) ||
        !memory->reserve(std::uint64_t{offset} + bytes))
        return false;
    unmap(begin, bytes);
    void* const fresh =
        mmap(host_ + begin, bytes, memory->is_writable() ? PROT_READ | PROT_WRITE : PROT_READ,
             MAP_SHARED | MAP_FIXED, memory->fd(), static_cast<off_t>(offset));
    if (fresh == MAP_FAILED) return false;
    insert(begin, {begin + bytes, access, false, offset, std::move(memory), is_file});
    if (!is_file) return true;
    if (!std::exchange(has_files_, true)) bus_errors::report(host_ + bottom_, host_ + top_);
    fit_to_files();
    return true;
}

void AddressSpace::fit_to_files() {
    if (!has_files_) return;
    for (auto it = areas_.begin(); it != areas_.end(); ++it) {
        const auto& [begin, area] = *it;
        if (!area.shared || !area.shared->is_file()) continue;
        const std::uint64_t size = (area.shared->size() + PAGE - 1) / PAGE * PAGE;
        const std::uint64_t left = size > area.physical ? size - area.physical : 0;
        if (left > 0 && left < area.end - begin) split(begin + static_cast<std::uint32_t>(left));
        disconnect(it);
        it->second.is_beyond = left == 0;
        connect(it);
    }
    join_all(bottom_, top_);
}

void AddressSpace::unmap(std::uint32_t begin, std::uint32_t bytes) {
    split(begin);
    split(begin + bytes);
    for (auto it = areas_.lower_bound(begin); it != areas_.end() && it->first < begin + bytes;) {
        disconnect(it);
        count(it->first, it->second, false);
        if (!it->second.on_bus)  // gives the pages back to the host
            mmap(host_ + it->first, it->second.end - it->first, PROT_NONE,
                 MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED, -1, 0);
        it = remove(it);
    }
}

bool AddressSpace::protect(std::uint32_t begin, std::uint32_t bytes, unsigned access) {
    if (!is_mapped(begin, bytes)) return false;
    const std::uint32_t end = begin + bytes;
    std::uint64_t more = 0;
    for (std::uint32_t reached = begin; access != 0 && reached < end;) {
        const Area area = at(reached)->second;
        const std::uint32_t next = std::min(area.end, end);
        if (area.access == 0 && !area.on_bus && !area.shared) more += next - reached;
        reached = next;
    }
    if (all_ram_ + more > ALL_RAM || !has_areas()) return false;
    split(begin);
    split(end);
    for (auto it = areas_.lower_bound(begin); it != areas_.end() && it->first < end; ++it) {
        disconnect(it);
        count(it->first, it->second, false);
        it->second.access = access;
        count(it->first, it->second, true);
        connect(it);
    }
    join_all(begin, end);
    return true;
}

bool AddressSpace::is_after_file(std::uint32_t address) const {
    const auto area = at(address);
    return area && area->second.is_beyond;
}

bool AddressSpace::may_write(std::uint32_t begin, std::uint32_t bytes) const {
    auto area = areas_.upper_bound(begin);
    if (area != areas_.begin()) --area;
    for (; area != areas_.end() && area->first < begin + bytes; ++area)
        if (area->second.end > begin && area->second.shared && !area->second.shared->is_writable())
            return false;
    return true;
}

bool AddressSpace::is_mapped(std::uint32_t begin, std::uint32_t bytes) const {
    const std::uint64_t end = std::uint64_t{begin} + bytes;
    std::uint64_t reached = begin;
    while (reached < end) {
        const auto area = at(static_cast<std::uint32_t>(reached));
        if (!area) return false;
        reached = area->second.end;
    }
    return true;
}

bool AddressSpace::is_free(std::uint32_t begin, std::uint32_t bytes) const {
    const auto next = areas_.lower_bound(begin);
    return !at(begin) && (next == areas_.end() || next->first - begin >= bytes);
}

std::optional<std::uint32_t> AddressSpace::find_room(std::uint32_t bytes) const {
    std::uint32_t limit = top_ == TOP ? TOP - STACK_ROOM : top_;
    for (auto it = areas_.rbegin(); it != areas_.rend(); ++it) {
        if (it->second.end <= limit && limit - it->second.end >= bytes) return limit - bytes;
        limit = std::min(limit, it->first);
    }
    if (limit < bottom_ || limit - bottom_ < bytes) return std::nullopt;
    return limit - bytes;
}

std::optional<std::pair<std::uint32_t, AddressSpace::Area>> AddressSpace::at(
    std::uint32_t address) const {
    auto area = areas_.upper_bound(address);
    if (area == areas_.begin() || (--area)->second.end <= address) return std::nullopt;
    return *area;
}

// ---- The kernel's accesses ----------------------------------------------------------------------

std::uint8_t* AddressSpace::bytes(std::uint32_t address, std::size_t bytes, unsigned access) const {
    if (bytes == 0) return host_ + bottom_;
    const std::uint64_t end = std::uint64_t{address} + bytes;
    for (std::uint64_t reached = address; reached < end;) {
        const auto area = at(static_cast<std::uint32_t>(reached));
        if (reached >= top_ || !area || area->second.on_bus ||
            (area->second.access & access) != access ||
            is_after_end(area->first, area->second, static_cast<std::uint32_t>(reached)))
            return nullptr;
        reached = area->second.end;
    }
    return host_ + address;
}

bool AddressSpace::read(std::uint32_t address, void* data, std::size_t count) const {
    const std::uint8_t* from = bytes(address, count, arm_access::READ);
    if (from && count > 0) std::memcpy(data, from, count);
    return from != nullptr;
}

bool AddressSpace::write(std::uint32_t address, const void* data, std::size_t count) {
    std::uint8_t* to = bytes(address, count, arm_access::WRITE);
    if (to && count > 0) std::memcpy(to, data, count);
    return to != nullptr;
}

std::optional<std::string> AddressSpace::string(std::uint32_t address) const {
    std::string text;
    for (; text.size() < LONGEST_STRING; ++address) {
        char c;
        if (!read(address, &c, 1)) return std::nullopt;
        if (c == '\0') return text;
        text += c;
    }
    return std::nullopt;
}

}  // namespace sim
