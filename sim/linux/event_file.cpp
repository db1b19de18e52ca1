#include "sim/linux/event_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

constexpr std::uint32_t FIRST_MINOR = 64;

// Requests, by their low byte.
constexpr std::uint32_t VERSION = 0x01, IDENTITY = 0x02, REPETITION = 0x03, NAME = 0x06,
                        PLACE = 0x07, SERIAL = 0x08, PROPERTIES = 0x09, HELD_KEYS = 0x18,
                        LAMPS = 0x19, SOUNDS = 0x1A, SWITCHES = 0x1B, TYPES = 0x20, AXES = 0x40,
                        FORCE = 0x80, NO_FORCE = 0x81, FORCES = 0x84, GRAB = 0x90, CLOCK = 0xA0,
                        TO_KERNEL = 1;

std::vector<std::uint8_t> words(std::initializer_list<std::uint32_t> all) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint32_t word : all)
        for (unsigned i = 0; i < 32; i += 8) bytes.push_back(static_cast<std::uint8_t>(word >> i));
    return bytes;
}

std::vector<std::uint8_t> text_of(const std::string& text) {
    std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    bytes.push_back(0);
    return bytes;
}

}  // namespace

FileStatus EventFile::status() const {
    return {S_IFCHR | 0660, 0, 1, input_event::MAJOR << 8 | (FIRST_MINOR + number_)};
}

unsigned EventFile::can_do() const {
    return (queue_.empty() ? 0 : READ) | (device_->exists() ? WRITE : HUNG_UP | BROKEN);
}

std::int64_t EventFile::read(void* data, std::size_t bytes) {
    constexpr std::size_t SIZE = sizeof(InputEvent);
    if (bytes != 0 && bytes < SIZE) return -EINVAL;
    if (!device_->exists()) return -ENODEV;
    if (bytes == 0) return 0;
    if (queue_.empty()) return -EAGAIN;
    std::size_t count = 0;
    for (; (count + 1) * SIZE <= bytes && !queue_.empty(); ++count) {
        std::memcpy(static_cast<char*>(data) + count * SIZE, &queue_.front(), SIZE);
        queue_.pop_front();
    }
    return static_cast<std::int64_t>(count * SIZE);
}

// The lamps, the repetition.
std::int64_t EventFile::write(const void* data, std::size_t bytes) {
    if (bytes != 0 && bytes < sizeof(InputEvent)) return -EINVAL;
    if (!device_->exists()) return -ENODEV;
    std::size_t done = 0;
    for (; done + sizeof(InputEvent) <= bytes; done += sizeof(InputEvent)) {
        InputEvent event;
        std::memcpy(&event, static_cast<const char*>(data) + done, sizeof event);
        device_->event(event.type, event.code, event.value);
    }
    return static_cast<std::int64_t>(done);
}

void EventFile::hear(const InputEvent& event) {
    constexpr std::size_t MOST = 64;
    if (queue_.size() >= MOST) {
        queue_.clear();
        queue_.push_back({event.s, event.us, input_event::SYN, input_event::SYN_DROPPED, 0});
    }
    queue_.push_back(event);
    if (event.type == input_event::SYN) ++arrivals_;
}

// What the program learns at once is not told again.
void EventFile::forget(std::uint16_t type) {
    queue_.erase(std::remove_if(queue_.begin(), queue_.end(),
                                [&](const InputEvent& event) { return event.type == type; }),
                 queue_.end());
    for (std::size_t i = 0; i < queue_.size();) {
        const bool is_empty = queue_[i].type == input_event::SYN &&
                              queue_[i].code == input_event::SYN_REPORT &&
                              (i == 0 || (queue_[i - 1].type == input_event::SYN &&
                                          queue_[i - 1].code == input_event::SYN_REPORT));
        if (is_empty)
            queue_.erase(queue_.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
}

std::int64_t EventFile::give(std::uint32_t at, std::uint32_t room,
                             const std::vector<std::uint8_t>& bytes, AddressSpace& memory) const {
    const std::size_t count = std::min<std::size_t>(room, bytes.size());
    return memory.write(at, bytes.data(), count) ? static_cast<std::int64_t>(count) : -EFAULT;
}

std::int64_t EventFile::set(std::uint32_t what, std::uint32_t at, AddressSpace& memory) {
    constexpr std::uint32_t REALTIME = 0, MONOTONIC = 1, BOOTTIME = 7;
    std::uint32_t value[2];
    switch (what) {
        case REPETITION:
            if (!device_->has(input_event::REP)) return -ENOSYS;
            if (!memory.read(at, value, sizeof value)) return -EFAULT;
            for (const std::uint16_t which : {std::uint16_t{0}, std::uint16_t{1}})
                device_->event(input_event::REP, which, static_cast<int>(value[which]));
            return 0;
        case GRAB: return device_->grab(shared_from_this(), at != 0);
        case CLOCK:
            if (!memory.read(at, value, sizeof value[0])) return -EFAULT;
            return value[0] == REALTIME || value[0] == MONOTONIC || value[0] == BOOTTIME ? 0
                                                                                         : -EINVAL;
        case FORCE:
        case NO_FORCE: return -ENOSYS;
        default: return -EINVAL;
    }
}

std::int64_t EventFile::control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) {
    constexpr std::uint32_t LETTER = 'E', BUS_USB = 3;
    if (!device_->exists()) return -ENODEV;
    if ((request >> 8 & 0xFF) != LETTER) return -ENOTTY;  // FIONBIO and so on
    const std::uint32_t what = request & 0xFF, room = request >> 16 & 0x3FFF;
    if (request >> 30 & TO_KERNEL) return set(what, at, memory);
    const InputDevice::About& about = device_->about();
    const auto result = [](std::int64_t given) { return given < 0 ? given : 0; };
    const auto states = [&](std::uint16_t type) {
        forget(type);
        return give(at, room, device_->bits(type, true), memory);
    };
    switch (what) {
        case VERSION: return result(give(at, room, words({0x010001}), memory));
        case IDENTITY:
            return result(give(at, room,
                               words({BUS_USB | std::uint32_t{about.vendor} << 16,
                                      about.product | std::uint32_t{about.version} << 16}),
                               memory));
        case REPETITION:
            if (!device_->has(input_event::REP)) return -ENOSYS;
            return result(
                give(at, room, words({device_->repetition[0], device_->repetition[1]}), memory));
        case NAME: return give(at, room, text_of(about.name), memory);
        case PLACE: return give(at, room, text_of(about.place), memory);
        case SERIAL: return give(at, room, text_of(""), memory);
        case PROPERTIES: return give(at, room, words({0}), memory);
        case HELD_KEYS: return states(input_event::KEY);
        case LAMPS: return states(input_event::LED);
        case SOUNDS: return states(input_event::SND);
        case SWITCHES: return states(input_event::SW);
        case FORCES: return result(give(at, room, words({0}), memory));
        default: break;
    }
    if (what >= TYPES && what < AXES) {
        const auto type = static_cast<std::uint16_t>(what - TYPES);
        if (InputDevice::codes_of(type) == 0) return -EINVAL;
        return give(at, room, device_->bits(type), memory);
    }
    if (what >= AXES && what < FORCE) {
        if (device_->axes().empty()) return -EINVAL;
        InputDevice::Axis axis{};
        const auto found = device_->axes().find(static_cast<std::uint16_t>(what - AXES));
        if (found != device_->axes().end()) axis = found->second;
        std::vector<std::uint8_t> bytes(sizeof axis);
        std::memcpy(bytes.data(), &axis, sizeof axis);
        return result(give(at, room, bytes, memory));
    }
    return -EINVAL;
}

}  // namespace sim
