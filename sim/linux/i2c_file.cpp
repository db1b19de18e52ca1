#include "sim/linux/i2c_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

constexpr std::uint64_t BIT_PS = 10'000'000;  // 100 kHz
constexpr std::uint32_t RETRIES = 0x0701, TIMEOUT = 0x0702, SLAVE = 0x0703, TENBIT = 0x0704,
                        FUNCTIONS = 0x0705, SLAVE_FORCE = 0x0706, RDWR = 0x0707, PEC = 0x0708,
                        SMBUS = 0x0720;
// I2C, and SMBus' bytes, words and I2C blocks.
constexpr std::uint32_t HAS = 0x00000001 | 0x00060000 | 0x00180000 | 0x00600000 | 0x0C000000;
constexpr std::size_t MOST_OF_MESSAGE = 8192, SMBUS_BLOCK = 32;

struct WireMessage {  // struct i2c_msg
    std::uint16_t address, flags, bytes, pad;
    std::uint32_t at;
};
constexpr std::uint16_t READS = 1, TEN_BITS = 0x10;

}  // namespace

FileStatus I2cFile::status() const { return {S_IFCHR | 0600, 0, 1, 89 << 8}; }

// START, the address and its bytes, for each message; then STOP.
std::int64_t I2cFile::transfer(std::vector<Message>& messages) {
    const auto byte_passes = [this] { pass_(9 * BIT_PS); };
    std::int64_t error = 0;
    for (Message& message : messages) {
        pass_(BIT_PS);
        byte_passes();
        if (!devices_.begin(message.address, message.reads, BIT_PS, now_ps_())) error = -EREMOTEIO;
        for (std::uint8_t& byte : message.bytes) {
            if (error) break;
            byte_passes();
            if (message.reads)
                byte = devices_.read(now_ps_());
            else if (!devices_.write(byte, now_ps_()))
                error = -EREMOTEIO;
        }
        if (error) break;
    }
    devices_.end(now_ps_());
    pass_(BIT_PS);
    return error;
}

std::int64_t I2cFile::read(void* data, std::size_t bytes) {
    std::vector<Message> one{{address_, true, {}}};
    one[0].bytes.resize(std::min(bytes, MOST_OF_MESSAGE));
    if (const std::int64_t error = transfer(one)) return error;
    std::copy(one[0].bytes.begin(), one[0].bytes.end(), static_cast<std::uint8_t*>(data));
    return static_cast<std::int64_t>(one[0].bytes.size());
}

std::int64_t I2cFile::write(const void* data, std::size_t bytes) {
    const auto* const from = static_cast<const std::uint8_t*>(data);
    const std::size_t count = std::min(bytes, MOST_OF_MESSAGE);
    std::vector<Message> one{{address_, false, {from, from + count}}};
    const std::int64_t error = transfer(one);
    return error ? error : static_cast<std::int64_t>(count);
}

std::int64_t I2cFile::control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) {
    switch (request) {
        case SLAVE:
        case SLAVE_FORCE:
            if (at > 0x7F) return -EINVAL;
            address_ = static_cast<std::uint8_t>(at);
            return 0;
        case TENBIT: return at ? -EINVAL : 0;
        case RETRIES:
        case TIMEOUT: return 0;
        case PEC: return at ? -EINVAL : 0;
        case FUNCTIONS: return memory.write(at, &HAS, sizeof HAS) ? 0 : -EFAULT;
        case RDWR: return messages(at, memory);
        case SMBUS: return smbus(at, memory);
        default: return -ENOTTY;
    }
}

// struct i2c_rdwr_ioctl_data
std::int64_t I2cFile::messages(std::uint32_t at, AddressSpace& memory) {
    constexpr std::uint32_t MOST = 42;
    std::uint32_t list[2];
    if (!memory.read(at, list, sizeof list)) return -EFAULT;
    if (list[0] == 0 || list[1] == 0 || list[1] > MOST) return -EINVAL;
    std::vector<WireMessage> wire(list[1]);
    if (!memory.read(list[0], wire.data(), wire.size() * sizeof(WireMessage))) return -EFAULT;
    std::vector<Message> all;
    for (const WireMessage& each : wire) {
        if (each.bytes > MOST_OF_MESSAGE || each.address > 0x7F || each.flags & TEN_BITS)
            return -EINVAL;
        Message message{static_cast<std::uint8_t>(each.address), (each.flags & READS) != 0, {}};
        message.bytes.resize(each.bytes);
        if (!memory.read(each.at, message.bytes.data(), each.bytes)) return -EFAULT;
        all.push_back(std::move(message));
    }
    if (const std::int64_t error = transfer(all)) return error;
    for (std::size_t i = 0; i < wire.size(); ++i)
        if (all[i].reads && !memory.write(wire[i].at, all[i].bytes.data(), wire[i].bytes))
            return -EFAULT;
    return static_cast<std::int64_t>(all.size());
}

// struct i2c_smbus_ioctl_data: direction, command, size, and where the data are: a byte, a word, or
// a block after its length.
std::int64_t I2cFile::smbus(std::uint32_t at, AddressSpace& memory) {
    enum Size : std::uint32_t {
        BYTE = 1,
        BYTE_DATA = 2,
        WORD_DATA = 3,
        BLOCK_BROKEN = 6,
        BLOCK = 8
    };
    struct {
        std::uint8_t reads, command, pad[2];
        std::uint32_t size, data;
    } asked;
    if (!memory.read(at, &asked, sizeof asked)) return -EFAULT;
    const bool reads = asked.reads, block = asked.size == BLOCK || asked.size == BLOCK_BROKEN;
    if (!block && (asked.size < BYTE || asked.size > WORD_DATA)) return -EOPNOTSUPP;
    std::uint8_t length = asked.size == WORD_DATA ? 2 : 1;
    if (block && !memory.read(asked.data, &length, 1)) return -EFAULT;
    if (block && (length == 0 || length > SMBUS_BLOCK)) return -EINVAL;
    const std::uint32_t data = asked.data + (block ? 1 : 0);

    std::vector<std::uint8_t> bytes(length);
    std::vector<Message> all{{address_, false, {asked.command}}};
    if (reads) {
        if (asked.size == BYTE) all.clear();
        all.push_back({address_, true, bytes});
    } else if (asked.size != BYTE) {
        if (!memory.read(data, bytes.data(), length)) return -EFAULT;
        all[0].bytes.insert(all[0].bytes.end(), bytes.begin(), bytes.end());
    }
    if (const std::int64_t error = transfer(all)) return error;
    return !reads || memory.write(data, all.back().bytes.data(), length) ? 0 : -EFAULT;
}

}  // namespace sim
