// ipc.h - what System V's memory, semaphores and message queues have in common.
//
// Source: Linux 6.1, include/uapi/linux/ipc.h; struct ipc64_perm.
#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "sim/linux/shared_memory.h"

namespace sim::ipc {

constexpr std::uint32_t PRIVATE_KEY = 0, CREATE = 01000, EXCLUSIVE = 02000, NO_WAIT = 04000,
                        RIGHTS = 0777;
constexpr std::uint32_t REMOVE = 0, CHANGE = 1, STATUS = 2, NEW_LAYOUT = 0x100;
constexpr std::size_t MOST = 256;  // objects of a kind

struct Rights {
    std::int32_t key;
    std::uint32_t user, group, owner, owner_group;
    std::uint16_t mode, pad, sequence, pad2;
    std::uint32_t unused[2];
};
static_assert(sizeof(Rights) == 36);

struct Segment {  // of memory
    std::uint32_t key, rights;
    std::shared_ptr<SharedMemory> memory;
    int maker;
    bool removed = false;
};
struct Semaphores {
    std::uint32_t key, rights;
    std::vector<std::uint16_t> values;
    bool removed = false;
};

// The object by its key, or a new one; or minus the error.
template <class Object>
std::int64_t find_or_make(std::map<int, Object>& all, int& next, std::uint32_t key,
                          std::uint32_t flags, const Object& made, bool can_be_made) {
    if (key != PRIVATE_KEY)
        for (const auto& [number, object] : all)
            if (object.key == key && !object.removed)
                return (flags & CREATE) && (flags & EXCLUSIVE) ? -EEXIST : number;
    if (key != PRIVATE_KEY && !(flags & CREATE)) return -ENOENT;
    if (!can_be_made) return -EINVAL;
    if (all.size() >= MOST) return -ENOSPC;
    all.emplace(next, made);
    return next++;
}

}  // namespace sim::ipc
