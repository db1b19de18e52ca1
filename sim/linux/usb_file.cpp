#include "sim/linux/usb_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

namespace sim {

namespace {

// USBDEVFS_ numbers.
constexpr std::uint8_t RESET_ENDPOINT = 3, SET_INTERFACE = 4, SET_CONFIGURATION = 5, GET_DRIVER = 8,
                       SUBMIT = 10, DISCARD = 11, REAP_NOW = 13, CLAIM = 15, RELEASE = 16,
                       CONNECT_INFO = 17, DRIVER = 18, CLEAR_HALT = 21, DISCONNECT = 22,
                       CONNECT = 23, CAPABILITIES = 26, TAKE = 27, SPEED = 31;

struct Control {  // struct usbdevfs_ctrltransfer
    UsbSetup setup;
    std::uint32_t ms, data;
};
static_assert(sizeof(Control) == 16);

struct Bulk {  // struct usbdevfs_bulktransfer
    std::uint32_t endpoint, bytes, ms, data;
};

constexpr std::size_t MOST_BYTES = 1 << 20;  // of a transfer

}  // namespace

struct UsbFile::Urb {  // struct usbdevfs_urb
    std::uint8_t type, endpoint;
    std::int32_t status;
    std::uint32_t flags, buffer;
    std::int32_t bytes, actual, start_frame, packets, errors;
    std::uint32_t signal, context;
};

UsbFile::~UsbFile() {
    if (node_->owner == this) bus_.bind(*node_, "");
}

FileStatus UsbFile::status() const {
    return {S_IFCHR | 0664, 0, 1, UsbBus::MAJOR << 8 | (node_->number - 1)};
}

std::string UsbFile::name() const {
    return node_->device ? "the " + node_->product : "USB device " + node_->name;
}

unsigned UsbFile::can_do() const {
    const bool any = std::any_of(transfers_.begin(), transfers_.end(),
                                 [](const auto& transfer) { return transfer->done; });
    return (any ? WRITE : 0) | (node_->connected ? 0 : HUNG_UP | BROKEN);
}

std::int64_t UsbFile::read(void* data, std::size_t bytes) {
    const std::int64_t count = read_at(data, bytes, at_);
    if (count > 0) at_ += count;
    return count;
}

std::int64_t UsbFile::read_at(void* data, std::size_t bytes, std::int64_t offset) {
    if (!node_->connected) return -ENODEV;
    if (offset < 0) return -EINVAL;
    UsbBytes all = node_->descriptor;
    all.insert(all.end(), node_->configuration.begin(), node_->configuration.end());
    const std::size_t from = std::min(static_cast<std::size_t>(offset), all.size());
    const std::size_t count = std::min(bytes, all.size() - from);
    std::memcpy(data, all.data() + from, count);
    return static_cast<std::int64_t>(count);
}

std::int64_t UsbFile::seek(std::int64_t offset, int whence) {
    if (whence != SEEK_SET && whence != SEEK_CUR) return -EINVAL;
    const std::int64_t to = whence == SEEK_SET ? offset : at_ + offset;
    return to < 0 ? -EINVAL : at_ = to;
}

// ---- Who has the interface ----------------------------------------------------------------------

// Also by a transfer, unless it is this file's already.
int UsbFile::claim(std::uint32_t interface) {
    if (interface >= 32) return -EINVAL;
    if (interface != 0) return -ENOENT;
    if (node_->owner == this) return 0;
    if (!node_->driver.empty()) return -EBUSY;
    bus_.bind(*node_, "usbfs", this);
    return 0;
}

// Requests to an interface or an endpoint are for who has that.
int UsbFile::may_ask(const UsbSetup& setup) {
    constexpr std::uint8_t KIND = 0x60, VENDOR = 0x40, RECIPIENT = 0x1F, INTERFACE = 1,
                           ENDPOINT = 2;
    if ((setup.type & KIND) == VENDOR) return 0;
    const auto index = static_cast<std::uint8_t>(setup.index);
    if ((setup.type & RECIPIENT) == INTERFACE) return claim(index);
    if ((setup.type & RECIPIENT) != ENDPOINT || (index & ~UsbBus::IN) == 0) return 0;
    return node_->has_endpoint(index) ? claim(0) : -ENOENT;
}

std::int64_t UsbFile::driver_request(std::uint32_t interface, std::uint32_t request) {
    if (interface != 0) return -EINVAL;
    switch (request & 0xFF) {
        case DISCONNECT:
            if (node_->driver.empty()) return -ENODATA;
            bus_.bind(*node_, "");
            return 0;
        case CONNECT:
            if (!node_->driver.empty()) return -EBUSY;
            bus_.bind(*node_, node_->device ? "usbhid" : "hub");
            return 1;
        default: return -ENOTTY;
    }
}

// DISCONNECT_CLAIM
std::int64_t UsbFile::take_from(std::uint32_t at, AddressSpace& memory) {
    constexpr std::uint32_t IF_DRIVER = 1, EXCEPT_DRIVER = 2;
    struct {
        std::uint32_t interface, flags;
        std::array<char, 256> driver;
    } asked;
    if (!memory.read(at, &asked, sizeof asked)) return -EFAULT;
    if (asked.interface != 0) return -EINVAL;
    asked.driver.back() = 0;
    if (!node_->driver.empty()) {
        const bool is_named = node_->driver == asked.driver.data();
        if ((asked.flags & IF_DRIVER) && !is_named) return -EBUSY;
        if ((asked.flags & EXCEPT_DRIVER) && is_named) return -EBUSY;
        bus_.bind(*node_, "");
    }
    return claim(0);
}

std::int64_t UsbFile::name_driver(std::uint32_t at, AddressSpace& memory) const {
    std::uint32_t interface;
    if (!memory.read(at, &interface, sizeof interface)) return -EFAULT;
    if (interface != 0 || node_->driver.empty()) return -ENODATA;
    return memory.write(at + 4, node_->driver.c_str(), node_->driver.size() + 1) ? 0 : -EFAULT;
}

// ---- Transfers ----------------------------------------------------------------------------------

std::int64_t UsbFile::submit(std::uint32_t at, AddressSpace& memory) {
    constexpr std::uint8_t INTERRUPT = 1, CONTROL_TYPE = 2, BULK_TYPE = 3;
    constexpr std::size_t SETUP = sizeof(UsbSetup);
    Urb urb;
    if (!memory.read(at, &urb, sizeof urb)) return -EFAULT;
    if (urb.bytes < 0 || static_cast<std::size_t>(urb.bytes) > MOST_BYTES) return -EINVAL;
    auto transfer = std::make_shared<UsbTransfer>();
    transfer->endpoint = urb.endpoint & ~UsbBus::IN ? urb.endpoint : std::uint8_t{0};
    transfer->urb = at;
    transfer->buffer = urb.buffer;
    transfer->room = static_cast<std::size_t>(urb.bytes);
    if (transfer->endpoint == 0) {
        if (urb.type != CONTROL_TYPE || transfer->room < SETUP) return -EINVAL;
        UsbSetup& setup = transfer->setup;
        if (!memory.read(urb.buffer, &setup, SETUP)) return -EFAULT;
        if (transfer->room < SETUP + setup.length) return -EINVAL;
        if (const int error = may_ask(setup)) return error;
        transfer->buffer += SETUP;
        transfer->room = setup.length;
        if (!(setup.type & UsbBus::IN)) {
            transfer->data.resize(setup.length);
            if (!memory.read(transfer->buffer, transfer->data.data(), setup.length)) return -EFAULT;
        }
    } else {
        if (!node_->has_endpoint(urb.endpoint)) return -ENOENT;
        if (const int error = claim(0)) return error;
        if (urb.type != INTERRUPT && urb.type != BULK_TYPE) return -EINVAL;
    }
    transfers_.push_back(transfer);
    bus_.submit(node_, transfer);
    return 0;
}

// The first that was done.
std::int64_t UsbFile::reap(std::uint32_t at, AddressSpace& memory) {
    auto first = transfers_.end();
    for (auto it = transfers_.begin(); it != transfers_.end(); ++it)
        if ((*it)->done && (first == transfers_.end() || (*it)->order < (*first)->order))
            first = it;
    if (first == transfers_.end()) return node_->connected ? -EAGAIN : -ENODEV;
    const std::shared_ptr<UsbTransfer> transfer = *first;
    transfers_.erase(first);
    Urb urb;
    const std::int64_t bytes = finish(*transfer, memory);
    if (bytes == -EFAULT || !memory.read(transfer->urb, &urb, sizeof urb)) return -EFAULT;
    urb.status = transfer->status;
    urb.actual = static_cast<std::int32_t>(transfer->data.size());
    urb.errors = 0;
    const bool written = memory.write(transfer->urb, &urb, sizeof urb) &&
                         memory.write(at, &transfer->urb, sizeof transfer->urb);
    return written ? 0 : -EFAULT;
}

std::int64_t UsbFile::discard(std::uint32_t urb) {
    for (const auto& transfer : transfers_)
        if (transfer->urb == urb && !transfer->done) {
            cancel(*transfer);
            return 0;
        }
    return -EINVAL;
}

UsbFile::Begun UsbFile::begin(std::uint32_t request, std::uint32_t at, AddressSpace& memory) {
    if (!node_->connected) return {-ENODEV, nullptr, 0};
    auto transfer = std::make_shared<UsbTransfer>();
    std::uint32_t ms;
    if ((request & 0xFF) == CONTROL) {
        Control control;
        if (!memory.read(at, &control, sizeof control)) return {-EFAULT, nullptr, 0};
        if (const int error = may_ask(control.setup)) return {error, nullptr, 0};
        transfer->setup = control.setup;
        transfer->room = control.setup.length;
        transfer->buffer = control.data;
        ms = control.ms;
        if (!(control.setup.type & UsbBus::IN)) {
            transfer->data.resize(transfer->room);
            if (!memory.read(control.data, transfer->data.data(), transfer->room))
                return {-EFAULT, nullptr, 0};
        }
    } else {
        Bulk bulk;
        if (!memory.read(at, &bulk, sizeof bulk)) return {-EFAULT, nullptr, 0};
        transfer->endpoint = static_cast<std::uint8_t>(bulk.endpoint);
        if (!node_->has_endpoint(transfer->endpoint)) return {-ENOENT, nullptr, 0};
        if (const int error = claim(0)) return {error, nullptr, 0};
        if (bulk.bytes > MOST_BYTES) return {-EINVAL, nullptr, 0};
        transfer->room = bulk.bytes;
        transfer->buffer = bulk.data;
        ms = bulk.ms;
    }
    bus_.submit(node_, transfer);
    return {0, transfer, ms};
}

std::int64_t UsbFile::finish(const UsbTransfer& transfer, AddressSpace& memory) {
    const bool in = (transfer.endpoint ? transfer.endpoint : transfer.setup.type) & UsbBus::IN;
    const std::size_t bytes = std::min(transfer.data.size(), transfer.room);
    if (in && bytes > 0 && !memory.write(transfer.buffer, transfer.data.data(), bytes))
        return -EFAULT;
    return transfer.status ? transfer.status : static_cast<std::int64_t>(bytes);
}

// ---- Requests -----------------------------------------------------------------------------------

void UsbFile::reset() {
    for (const auto& transfer : transfers_) bus_.end(*transfer, -EPROTO);
    if (node_->device) node_->device->reset();
}

std::int64_t UsbFile::control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) {
    constexpr std::uint32_t ZERO_PACKET = 1, CONTINUES_BULK = 2, ANY_SIZE = 4, REAPS_LATER = 0x10;
    constexpr std::uint32_t LOW_SPEED = 1, HIGH_SPEED = 3;
    if (!is_request(request)) return -ENOTTY;
    const auto what = static_cast<std::uint8_t>(request);
    if (what == REAP || what == REAP_NOW) return reap(at, memory);
    if (!node_->connected) return -ENODEV;
    std::array<std::uint32_t, 3> words{};
    const auto read_words = [&](std::size_t count) {
        return memory.read(at, words.data(), 4 * count);
    };
    switch (what) {
        case SUBMIT: return submit(at, memory);
        case DISCARD: return discard(at);
        case RESET: reset(); return 0;
        case GET_DRIVER: return name_driver(at, memory);
        case TAKE: return take_from(at, memory);
        case SPEED: return node_->device ? LOW_SPEED : HIGH_SPEED;
        case CAPABILITIES:
            words[0] = ZERO_PACKET | CONTINUES_BULK | ANY_SIZE | REAPS_LATER;
            return memory.write(at, words.data(), 4) ? 0 : -EFAULT;
        case CONNECT_INFO:
            words = {node_->number, node_->device ? 1u : 0u};
            return memory.write(at, words.data(), 8) ? 0 : -EFAULT;
        default: break;
    }
    const std::size_t count = what == DRIVER ? 3 : what == SET_INTERFACE ? 2 : 1;
    if (!read_words(count)) return -EFAULT;
    switch (what) {
        case CLAIM: return claim(words[0]);
        case RELEASE:
            if (words[0] != 0 || node_->owner != this) return -EINVAL;
            bus_.bind(*node_, "");
            return 0;
        case SET_INTERFACE:
            if (const int error = claim(words[0])) return error;
            return words[1] == 0 ? 0 : -EINVAL;
        case SET_CONFIGURATION:
            if (!node_->driver.empty()) return -EBUSY;
            return words[0] == 1 ? 0 : -EINVAL;
        case RESET_ENDPOINT:
        case CLEAR_HALT:
            if (!node_->has_endpoint(static_cast<std::uint8_t>(words[0]))) return -ENOENT;
            return claim(0);
        case DRIVER: return driver_request(words[0], words[1]);
        default: return -ENOTTY;
    }
}

}  // namespace sim
