#include "sim/chip/de10_lite_computer.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "de10_lite.h"
#include "regmap.h"
#include "sim/hps/bridge_windows.h"

namespace sim {

namespace {

namespace lite = regmap::de10_lite;
using sc_core::sc_time;
using Answer = tlm::tlm_response_status;

constexpr std::uint32_t MEMORY_END = 0x10000000;
const sc_time OWN_ACCESS{100, sc_core::SC_NS};

// One access; what it is answered.
template <class Socket>
Answer transact(Socket& to, bool write, std::uint32_t address, std::uint8_t* data, unsigned bytes,
                sc_time& delay) {
    tlm::tlm_generic_payload tx;
    tx.set_command(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
    tx.set_address(address);
    tx.set_data_ptr(data);
    tx.set_data_length(bytes);
    tx.set_streaming_width(bytes);
    tx.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    to->b_transport(tx, delay);
    return tx.get_response_status();
}

std::vector<Bus::Place> places(bool memories) {
    std::vector<Bus::Place> all;
    for (const regmap::Block& block : lite::OWN_AND_SAME)
        if ((block.base < MEMORY_END) == memories)
            all.push_back({block.name, block.base, block.size, memories});
    return all;
}

std::map<std::uint32_t, std::string> registers_by_address() {
    std::map<std::uint32_t, std::string> names;
    for (const regmap::Reg& reg : lite::OWN_REGS) names.emplace(reg.addr, reg.name);
    for (const regmap::Reg& reg : regmap::REGS)
        if (const regmap::Block* const block = lite::block_at(reg.addr);
            block && lite::is_same(*block))
            names.emplace(reg.addr, reg.name);
    return names;
}

}  // namespace

// ---- The map ------------------------------------------------------------------------------------

De10LiteMap::De10LiteMap(const sc_core::sc_module_name& name, FpgaChip& fpga, Fabric& fabric,
                         De10LitePins& pins, const std::uint8_t* sdram,
                         std::function<void(unsigned line, bool up)> interrupt,
                         std::function<void(const std::string&)> log)
    : sc_module{name},
      memory{"memory"},
      registers{"registers"},
      to_memory{"to_memory"},
      to_registers{"to_registers"},
      picture{sdram, [&fabric](std::uint32_t offset, const std::uint8_t* data,
                               unsigned bytes) { fabric.write_onchip(offset, data, bytes); }},
      fpga_{fpga},
      fabric_{fabric},
      pins_{pins},
      log_{std::move(log)},
      arduino_{pins, [interrupt](bool up) { interrupt(lite::ARDUINO_LINE, up); }},
      converter_{pins},
      accelerometer_{"accelerometer", pins} {
    memory.register_b_transport(this, &De10LiteMap::transport_memory);
    memory.register_get_direct_mem_ptr(this, &De10LiteMap::direct_memory);
    registers.register_b_transport(this, &De10LiteMap::transport_registers);
    pins.on_samples([this](std::size_t count) { picture.beam(count); });
    pins.connect(fabric.in, [this] { arduino_.look(); });
}

bool De10LiteMap::direct_memory(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi) {
    return tx.get_address() < lite::SDRAM_SIZE && to_memory->get_direct_mem_ptr(tx, dmi);
}

// Word by word.
void De10LiteMap::transport(std::uint32_t base, tlm::tlm_generic_payload& tx, sc_time& delay) {
    if (tx.get_byte_enable_ptr()) {
        tx.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
        return;
    }
    auto address = base + static_cast<std::uint32_t>(tx.get_address());
    std::uint8_t* data = tx.get_data_ptr();
    Answer answer = tlm::TLM_OK_RESPONSE;
    for (unsigned left = tx.get_data_length(); left && answer == tlm::TLM_OK_RESPONSE;) {
        const unsigned bytes = std::min(left, 4 - address % 4);
        answer = word({tx.is_write(), address, data, bytes}, delay);
        address += bytes;
        data += bytes;
        left -= bytes;
    }
    tx.set_response_status(answer);
}

Answer De10LiteMap::word(const Access& a, sc_time& delay) {
    const regmap::Block* const block = lite::block_at(a.address);
    const bool is_memory = a.address < MEMORY_END;
    if (!block || (!is_memory && a.write && !lite::takes_writes(*block)))
        return elsewhere(a, delay);
    switch (block->base) {
        case lite::ONCHIP_BASE: return pixels(a, delay);
        case lite::KEY_BASE: return keys(a, delay);
        case lite::PIXEL_BASE: return controller(a, delay);
        case lite::TEXT_BASE: return text(a, delay);
        case lite::ACCELEROMETER_BASE: return accelerometer(a, delay);
        case lite::ARDUINO_BASE:
        case lite::ARDUINO_RESET_BASE:
        case lite::SYSID_BASE:
        case lite::ADC_BASE: return own(a, delay);
        default:
            return is_memory ? pass(to_memory, a, a.address, delay)
                             : pass(to_registers, a, a.address - LW_BASE, delay);
    }
}

Answer De10LiteMap::pass(Socket& to, const Access& a, std::uint32_t address, sc_time& delay) {
    return transact(to, a.write, address, a.data, a.bytes, delay);
}

Answer De10LiteMap::elsewhere(const Access& a, sc_time& delay) {
    const std::uint32_t in_sdram = a.address % lite::SDRAM_SIZE;
    const regmap::Block* const block = lite::block_at(a.address);
    std::uint32_t gap = 0;  // where it begins, as a place to speak of once
    for (const regmap::Block& before : lite::OWN_AND_SAME)
        if (before.base + before.size <= a.address) gap = std::max(gap, before.base + before.size);
    if (reported_.insert({block ? block->base : gap, a.write}).second)
        log_(fmt::format(
            "{} 0x{:08X}: {}; on the board, too, the interconnect sends it to the SDRAM at "
            "0x{:08X}",
            a.write ? "wrote" : "read", a.address,
            block ? fmt::format("{} cannot be written", block->name)
                  : std::string{"the DE10-Lite Computer has nothing there"},
            in_sdram));
    return pass(to_memory, a, in_sdram, delay);
}

void De10LiteMap::come_to(sc_time& delay) {
    delay += OWN_ACCESS;
    wait(delay);
    delay = sc_core::SC_ZERO_TIME;
    fpga_.catch_up();
}

// The bridge to the fabric's memory gives the time; what is in it, De10LitePicture.
Answer De10LiteMap::pixels(const Access& a, sc_time& delay) {
    const std::uint32_t offset = a.address - lite::ONCHIP_BASE;
    std::uint8_t bytes[4];
    std::memcpy(bytes, a.data, a.bytes);
    const std::uint32_t place = De10LitePicture::in_fabric(offset) + offset % 2;
    const Answer answer =
        transact(to_memory, a.write, lite::ONCHIP_BASE + place, bytes, a.bytes, delay);
    if (a.write)
        picture.write(offset, a.data, a.bytes);
    else
        picture.read(offset, a.data, a.bytes);
    return answer;
}

Answer De10LiteMap::keys(const Access& a, sc_time& delay) {
    constexpr std::uint8_t KEYS = 3;
    std::uint8_t bytes[4] = {};
    if (a.write && a.address % 4 == 0) bytes[0] = a.data[0] & KEYS;
    const Answer answer =
        transact(to_registers, a.write, a.address - LW_BASE, bytes, a.bytes, delay);
    if (!a.write) std::memcpy(a.data, bytes, a.bytes);
    return answer;
}

// ---- The pixel buffer controller ----

Answer De10LiteMap::controller(const Access& a, sc_time& delay) {
    constexpr std::uint32_t S = regmap::PIXEL_STATUS_S_MASK, EN = regmap::PIXEL_STATUS_EN_MASK;
    constexpr std::uint32_t ITS_OWN = 0xFFFF0000;
    const std::uint32_t number = a.address & ~3u, lane = a.address & 3;
    const auto fabric = [&](std::uint32_t address, bool write, std::uint32_t& value) {
        return transact(to_registers, write, address - LW_BASE,
                        reinterpret_cast<std::uint8_t*>(&value), sizeof value, delay);
    };
    if (!a.write) {
        std::uint32_t status = 0;
        const Answer answer = fabric(regmap::PIXEL_STATUS, false, status);
        picture.seen(status & S);
        const std::uint32_t value =
            number == lite::PIXEL_BUFFER        ? picture.front()
            : number == lite::PIXEL_BACK_BUFFER ? picture.back()
            : number == lite::PIXEL_RESOLUTION
                ? lite::PIXEL_RESOLUTION_RESET
                : (lite::PIXEL_STATUS_RESET & ITS_OWN) | (status & ~ITS_OWN);
        std::memcpy(a.data, reinterpret_cast<const std::uint8_t*>(&value) + lane, a.bytes);
        return answer;
    }
    if (number == lite::PIXEL_BUFFER) {
        come_to(delay);  // the last swap may be done
        std::uint32_t any = 1;
        const Answer answer = fabric(regmap::PIXEL_BUFFER, true, any);
        picture.ask(fabric_.clocks());
        return answer;
    }
    if (number == lite::PIXEL_BACK_BUFFER) {
        std::uint32_t back = picture.back(), one = regmap::PIXEL_BACK_BUFFER_RESET;
        std::memcpy(reinterpret_cast<std::uint8_t*>(&back) + lane, a.data, a.bytes);
        const Answer answer = fabric(regmap::PIXEL_BACK_BUFFER, true, one);
        picture.set_back(back);
        return answer;
    }
    const Answer answer = pass(to_registers, a, a.address - LW_BASE, delay);
    if (number == lite::PIXEL_STATUS && lane == 0) {
        pixels_on_ = a.data[0] & EN;
        picture.enable(pixels_on_ && text_on_);
    }
    return answer;
}

Answer De10LiteMap::text(const Access& a, sc_time& delay) {
    if (a.write && a.address == lite::TEXT_STATUS) {
        text_on_ = a.data[0] & regmap::TEXT_STATUS_EN_MASK;
        picture.enable(pixels_on_ && text_on_);
    }
    return pass(to_registers, a, a.address - LW_BASE, delay);
}

// ---- Its own devices ----

Answer De10LiteMap::own(const Access& a, sc_time& delay) {
    const std::uint32_t number = a.address & ~3u, lane = a.address & 3;
    const bool is_arduino = number - lite::ARDUINO_BASE < lite::ARDUINO_SIZE;
    const bool is_adc = number - lite::ADC_BASE < lite::ADC_SIZE;
    come_to(delay);
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    std::uint32_t value = 0;
    if (is_arduino && (!a.write || a.bytes != sizeof value))
        value = arduino_.read(number - lite::ARDUINO_BASE);
    if (number == lite::ARDUINO_RESET_DATA) value = arduino_runs_;
    if (is_adc && !a.write) {
        const std::uint64_t answers_ps = converter_.answers_ps(now_ps);
        if (answers_ps > now_ps) wait(sc_time::from_value(answers_ps - now_ps));
        value = converter_.read(number - lite::ADC_BASE, answers_ps);
    }
    auto* const part = reinterpret_cast<std::uint8_t*>(&value) + lane;
    if (!a.write) {
        std::memcpy(a.data, part, a.bytes);
        return tlm::TLM_OK_RESPONSE;
    }
    std::memcpy(part, a.data, a.bytes);
    if (is_arduino) {
        pins_.agenda.at(now_ps, [this, offset = number - lite::ARDUINO_BASE, value] {
            arduino_.write(offset, value);
        });
        fpga_.catch_up();
    } else if (is_adc) {
        converter_.write(number - lite::ADC_BASE, value, now_ps);
    } else if (number == lite::ARDUINO_RESET_DATA) {
        arduino_runs_ = value & 1;
    }
    return tlm::TLM_OK_RESPONSE;
}

Answer De10LiteMap::accelerometer(const Access& a, sc_time& delay) {
    come_to(delay);
    for (unsigned n = 0; n < a.bytes; ++n) {
        const unsigned offset = a.address + n - lite::ACCELEROMETER_BASE;
        if (a.write)
            accelerometer_.write(offset, a.data[n]);
        else
            a.data[n] = accelerometer_.read(offset);
    }
    return tlm::TLM_OK_RESPONSE;
}

// ---- The computer -------------------------------------------------------------------------------

De10LiteComputer::De10LiteComputer(const sc_core::sc_module_name& name, PinListener& pins,
                                   ChipObserver& observer, std::uint8_t* sdram,
                                   NiosVProgram program, const Settings& settings)
    : De10LiteBoardSide{pins},
      NiosVComputer{name, lite_pins, observer, sdram, std::move(program), settings, NoMap{}},
      map_{"map",
           fpga,
           fabric,
           lite_pins,
           sdram,
           [this](unsigned line, bool up) { set_line(line, up); },
           [this, &observer](const std::string& line) {
               if (!cpu.is_inspected()) observer.log(line + cpu.accessed());
           }} {
    bus.window("memory", 0, MEMORY_END).bind(map_.memory);
    bus.window("registers", LW_BASE, LW_SIZE).bind(map_.registers);
    map_.to_memory.bind(bridges.h2f);
    map_.to_registers.bind(window.socket);
    bus.name_registers(registers_by_address());
    bus.describe("memory", "the memories", places(true));
    bus.describe("registers", "the registers", places(false));
}

void De10LiteComputer::hps_accelerometer_interrupt(bool up) {
    set_line(lite::ACCELEROMETER_LINE, up);
}

// Of the blocks that are as on the DE1-SoC.
bool De10LiteComputer::is_plain(std::uint32_t address, bool write, std::uint32_t value) const {
    const regmap::Block* const block = lite::block_at(address);
    const bool is_as_there = block && (lite::is_same(*block) || block->base == lite::KEY_BASE ||
                                       block->base == lite::JP1_BASE);
    return is_as_there && (!write || lite::takes_writes(*block)) &&
           NiosVComputer::is_plain(address, write, value);
}

}  // namespace sim
