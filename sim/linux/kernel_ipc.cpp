// kernel_ipc.cpp - LinuxKernel's System V memory and semaphores
#include <algorithm>
#include <cerrno>
#include <csignal>

#include "sim/linux/arm_abi.h"
#include "sim/linux/ipc.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t SHM_READ_ONLY = 010000, SHM_ROUND_DOWN = 020000;
constexpr std::size_t MOST_SEMAPHORES = 256;
constexpr std::uint16_t MOST_VALUE = 32767;

}  // namespace

// ---- Memory -------------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_shmget(const Arguments& a) {
    ipc::Segment made{a[0], a[2] & ipc::RIGHTS, nullptr, process_->number};
    const bool can = a[1] > 0 && a[1] <= AddressSpace::RAM;
    const std::int64_t number = ipc::find_or_make(segments_, next_ipc_, a[0], a[2], made, can);
    if (number < 0) return number;
    ipc::Segment& segment = segments_.at(static_cast<int>(number));
    if (!segment.memory) {
        segment.memory = std::make_shared<SharedMemory>();
        if (!segment.memory->resize(a[1])) {
            segments_.erase(static_cast<int>(number));
            return -ENOMEM;
        }
    }
    return a[1] > segment.memory->size() ? -EINVAL : number;
}

LinuxKernel::Result LinuxKernel::sys_shmat(const Arguments& a) {
    const auto found = segments_.find(static_cast<int>(a[0]));
    if (found == segments_.end()) return -EINVAL;
    std::uint32_t at = a[1];
    const std::uint32_t beyond = at % AddressSpace::PAGE;
    if (beyond != 0 && !(a[2] & SHM_ROUND_DOWN)) return -EINVAL;
    at -= beyond;
    const auto bytes =
        static_cast<std::uint32_t>((found->second.memory->size() + AddressSpace::PAGE - 1) &
                                   ~std::uint64_t{AddressSpace::PAGE - 1});
    if (at != 0 && (at < AddressSpace::BOTTOM || at > AddressSpace::TOP - bytes ||
                    !memory().is_free(at, bytes)))
        return -EINVAL;
    if (at == 0) {
        const auto room = memory().find_room(bytes);
        if (!room) return -ENOMEM;
        at = *room;
    }
    const unsigned access = arm_access::READ | (a[2] & SHM_READ_ONLY ? 0 : arm_access::WRITE);
    if (!memory().map_shared(at, bytes, access, found->second.memory, 0)) return -ENOMEM;
    process_->segments[at] = found->first;
    return at;
}

// How often it is mapped, by all processes.
std::uint32_t LinuxKernel::attachments(int segment) const {
    std::uint32_t count = 0;
    for (const auto& process : processes_)
        for (const auto& entry : process->segments) count += entry.second == segment;
    return count;
}

void LinuxKernel::remove_unused(int segment) {
    const auto found = segments_.find(segment);
    if (found != segments_.end() && found->second.removed && attachments(segment) == 0)
        segments_.erase(found);
}

LinuxKernel::Result LinuxKernel::sys_shmdt(const Arguments& a) {
    const auto found = process_->segments.find(a[0]);
    if (found == process_->segments.end()) return -EINVAL;
    const int number = found->second;
    const auto bytes =
        static_cast<std::uint32_t>((segments_.at(number).memory->size() + AddressSpace::PAGE - 1) &
                                   ~std::uint64_t{AddressSpace::PAGE - 1});
    process_->segments.erase(found);
    memory().unmap(a[0], bytes);
    remove_unused(number);
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_shmctl(const Arguments& a) {
    const auto found = segments_.find(static_cast<int>(a[0]));
    if (found == segments_.end()) return -EINVAL;
    ipc::Segment& segment = found->second;
    switch (a[1] & ~ipc::NEW_LAYOUT) {
        case ipc::REMOVE:
            segment.removed = true;
            remove_unused(found->first);
            return 0;
        case ipc::CHANGE: return 0;
        case ipc::STATUS: {
            struct {
                ipc::Rights rights;
                std::uint32_t size, times[6], maker, last, attached, unused[2];
            } all{};
            static_assert(sizeof all == 84);
            all.rights.key = static_cast<std::int32_t>(segment.key);
            all.rights.mode = static_cast<std::uint16_t>(segment.rights);
            all.size = static_cast<std::uint32_t>(segment.memory->size());
            all.maker = static_cast<std::uint32_t>(segment.maker);
            all.attached = attachments(found->first);
            return memory().write(a[2], &all, sizeof all) ? 0 : -EFAULT;
        }
        default: return -EINVAL;
    }
}

// ---- Semaphores ---------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_semget(const Arguments& a) {
    const bool can = a[1] > 0 && a[1] <= MOST_SEMAPHORES;
    const ipc::Semaphores made{a[0], a[2] & ipc::RIGHTS,
                               std::vector<std::uint16_t>(can ? a[1] : 0)};
    const std::int64_t number = ipc::find_or_make(semaphores_, next_ipc_, a[0], a[2], made, can);
    if (number < 0) return number;
    return a[1] > semaphores_.at(static_cast<int>(number)).values.size() ? -EINVAL : number;
}

LinuxKernel::Result LinuxKernel::sys_semctl(const Arguments& a) {
    constexpr std::uint32_t GET_PROCESS = 11, GET = 12, GET_ALL = 13, WAITING = 14, WAITING_0 = 15,
                            SET_ONE = 16, SET_ALL = 17;
    const auto found = semaphores_.find(static_cast<int>(a[0]));
    if (found == semaphores_.end()) return -EINVAL;
    std::vector<std::uint16_t>& values = found->second.values;
    const std::uint32_t command = a[2] & ~ipc::NEW_LAYOUT,
                        bytes = static_cast<std::uint32_t>(2 * values.size());
    const bool of_one = command == GET || command == SET_ONE || command == GET_PROCESS ||
                        command == WAITING || command == WAITING_0;
    if (of_one && a[1] >= values.size()) return -EINVAL;
    switch (command) {
        case ipc::REMOVE:
            semaphores_.erase(found);
            changed_ = true;
            return 0;
        case ipc::CHANGE: return 0;
        case GET: return values[a[1]];
        case GET_ALL: return memory().write(a[3], values.data(), bytes) ? 0 : -EFAULT;
        case GET_PROCESS:
        case WAITING:
        case WAITING_0: return 0;
        case SET_ONE:
            if (a[3] > MOST_VALUE) return -ERANGE;
            values[a[1]] = static_cast<std::uint16_t>(a[3]);
            changed_ = true;
            return 0;
        case SET_ALL:
            changed_ = true;
            return memory().read(a[3], values.data(), bytes) ? 0 : -EFAULT;
        case ipc::STATUS: {
            struct {
                ipc::Rights rights;
                std::uint32_t times[4], count, unused[2];
            } all{};
            all.rights.key = static_cast<std::int32_t>(found->second.key);
            all.rights.mode = static_cast<std::uint16_t>(found->second.rights);
            all.count = static_cast<std::uint32_t>(values.size());
            return memory().write(a[3], &all, sizeof all) ? 0 : -EFAULT;
        }
        default: return -EINVAL;
    }
}

// All of the operations at once, or none.
LinuxKernel::Result LinuxKernel::semop(const Arguments& a, std::int64_t span) {
    constexpr std::uint32_t MOST_OPERATIONS = 500;
    struct Operation {
        std::uint16_t number;
        std::int16_t change;
        std::uint16_t flags;
    };
    static_assert(sizeof(Operation) == 6);
    if (span < 0) return span;
    if (a[2] == 0) return -EINVAL;
    if (a[2] > MOST_OPERATIONS) return -E2BIG;
    std::vector<Operation> operations(a[2]);
    if (!memory().read(a[1], operations.data(), a[2] * sizeof(Operation))) return -EFAULT;
    LinuxWait wait;
    wait.what = "a semaphore";
    wait.inside = true;
    if (span < static_cast<std::int64_t>(LONGEST_NS)) {
        wait.at_ns = later_ns(static_cast<std::uint64_t>(span));
        wait.inside = false;
    }
    wait.look = [this, number = static_cast<int>(a[0]), operations,
                 first = true](LinuxWait& w) mutable -> Result {
        const auto found = semaphores_.find(number);
        if (found == semaphores_.end()) return std::exchange(first, false) ? -EINVAL : -EIDRM;
        first = false;
        std::vector<std::uint16_t> values = found->second.values;
        for (const Operation& operation : operations) {
            if (operation.number >= values.size()) return -EFBIG;
            const int value = values[operation.number] + operation.change;
            const bool waits = operation.change == 0 ? value != 0 : value < 0;
            if (value > MOST_VALUE) return -ERANGE;
            if (waits && (operation.flags & ipc::NO_WAIT)) return -EAGAIN;
            if (waits) return now_ns() >= w.at_ns ? Result{-EAGAIN} : std::nullopt;
            values[operation.number] = static_cast<std::uint16_t>(value);
        }
        found->second.values = std::move(values);
        changed_ = true;
        return 0;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_semop(const Arguments& a) { return semop(a, LONGEST_NS); }
LinuxKernel::Result LinuxKernel::sys_semtimedop(const Arguments& a) {
    return semop(a, span_at(a[3], Span::TIMESPEC));
}
LinuxKernel::Result LinuxKernel::sys_semtimedop_time64(const Arguments& a) {
    return semop(a, span_at(a[3], Span::TIMESPEC64));
}

}  // namespace sim
