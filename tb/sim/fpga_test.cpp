// The real fpga.v in SystemC: TLM transactions become AXI bursts, and time goes by.
#include "sim/chip/fpga_bridges.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

#include <tlm_utils/simple_initiator_socket.h>

#include "regmap.h"
#include "sim/board/is42s16320d.h"
#include "sim/fpga/fabric.h"

namespace {

using sc_core::sc_time;

constexpr std::uint32_t LW = 0xFF200000;
constexpr std::uint32_t ONCHIP = regmap::ONCHIP_BASE - 0xC0000000,
                        SDRAM = regmap::SDRAM_BASE - 0xC0000000;

// The board has only the SDRAM.
struct Pins : sim::PinListener {
    sim::Is42s16320d chip;
    void sdram(const sim::SdramPins& p, std::uint64_t time_ps, std::uint16_t& dq,
               bool& more) override {
        chip.clock({p.cs_n, p.ras_n, p.cas_n, p.we_n, p.ba, p.addr, p.dqm, p.dq_driven, p.dq},
                   time_ps);
        dq = chip.dq();
        more = chip.busy();
    }
    std::uint64_t samples = 0;
    void video(const std::uint32_t*, std::size_t count) override { samples += count; }
    void codec(const sim::CodecPins&, std::uint64_t, sim::ChipInputs&) override {}
    void headers(const sim::HeaderPins& pins, std::uint64_t, sim::ChipInputs&) override {
        header = pins;
    }
    void adc(const sim::AdcPins&, std::uint64_t, sim::ChipInputs&) override {}
    void ps2(unsigned, unsigned, std::uint64_t, sim::ChipInputs&) override {}
    sim::HeaderPins header{};
};

// Runs a test's body as a process, where b_transport may wait.
class Initiator : public sc_core::sc_module {
public:
    tlm_utils::simple_initiator_socket<Initiator> lw{"lw"}, h2f{"h2f"};
    std::function<void()> body;

    explicit Initiator(const sc_core::sc_module_name& name) : sc_module{name} {
        SC_HAS_PROCESS(Initiator);
        SC_THREAD(run);
    }

private:
    void run() {
        body();
        sc_core::sc_stop();
    }
};

class FpgaTest : public ::testing::Test {
protected:
    Pins pins;
    sim::Fabric fabric{pins};
    sim::FpgaChip fpga{"fpga", pins, fabric};
    sim::FpgaBridges bridges{"bridges", fpga, sim::FpgaBridges::Bursts::LONG};
    Initiator cpu{"cpu"};
    sc_time delay;

    void run(std::function<void()> body) {
        cpu.lw.bind(bridges.lw);
        cpu.h2f.bind(bridges.h2f);
        cpu.body = std::move(body);
        sc_core::sc_start();
    }
    tlm::tlm_response_status access(tlm_utils::simple_initiator_socket<Initiator>& socket,
                                    tlm::tlm_command command, std::uint32_t address, void* data,
                                    unsigned bytes) {
        return access(socket, command, address, data, bytes, delay);
    }
    tlm::tlm_response_status access(tlm_utils::simple_initiator_socket<Initiator>& socket,
                                    tlm::tlm_command command, std::uint32_t address, void* data,
                                    unsigned bytes, sc_time& its_delay) {
        tlm::tlm_generic_payload tx;
        tx.set_command(command);
        tx.set_address(address);
        tx.set_data_ptr(static_cast<unsigned char*>(data));
        tx.set_data_length(bytes);
        tx.set_streaming_width(bytes);
        socket->b_transport(tx, its_delay);
        return tx.get_response_status();
    }
    std::uint32_t read(std::uint32_t address) {
        std::uint32_t value = 0xdeadbeef;
        EXPECT_EQ(access(cpu.lw, tlm::TLM_READ_COMMAND, address - LW, &value, 4),
                  tlm::TLM_OK_RESPONSE);
        return value;
    }
    void now(sim::Agenda::Action action) {
        pins.agenda.at(sc_core::sc_time_stamp().value(), std::move(action));
    }
    void write(std::uint32_t address, std::uint32_t value) {
        EXPECT_EQ(access(cpu.lw, tlm::TLM_WRITE_COMMAND, address - LW, &value, 4),
                  tlm::TLM_OK_RESPONSE);
    }
};

TEST_F(FpgaTest, StartsNoThread) {
    const auto threads = std::filesystem::directory_iterator{"/proc/self/task"};
    EXPECT_EQ(std::distance(begin(threads), end(threads)), 1);
}

TEST_F(FpgaTest, HasEveryRegistersResetValue) {
    run([this] {
        for (const auto& reg : regmap::REGS) {
            if (reg.addr == regmap::CODEC_STATUS) continue;  // set-up is under way
            const bool pulled_up = reg.addr == regmap::JP1_DATA || reg.addr == regmap::JP2_DATA;
            EXPECT_EQ(read(reg.addr), pulled_up                        ? 0xffffffffu
                                      : reg.addr == regmap::SYSID_HASH ? regmap::REGMAP_HASH
                                                                       : reg.reset)
                << reg.name;
        }
    });
}

TEST_F(FpgaTest, DrivesLampsAndReadsThemBack) {
    run([this] {
        write(regmap::LEDR_DATA, 0xffffffff);
        EXPECT_EQ(read(regmap::LEDR_DATA), 0x3ffu);
        EXPECT_EQ(fabric.ledr(), 0x3ff);
        write(regmap::HEX3_0_DATA, 0x06053f01);
        write(regmap::HEX5_4_DATA, 0x00007f40);
        const std::uint64_t lit = ~fabric.hex_n() & 0x3ffffffffff;
        EXPECT_EQ(lit, 0x7full << 35 | 0x40ull << 28 | 0x06ull << 21 | 0x05ull << 14 |
                           0x3full << 7 | 0x01ull);
    });
}

TEST_F(FpgaTest, ReadsSwitchesAndPressedKeysAndCapturesTheRelease) {
    run([this] {
        now([this] {
            fabric.in.sw = 0x2a5;
            fabric.in.key_n = 0xf & ~4u;
        });
        wait(1, sc_core::SC_US);
        EXPECT_EQ(read(regmap::SW_DATA), 0x2a5u);
        EXPECT_EQ(read(regmap::KEY_DATA), 4u);
        EXPECT_EQ(read(regmap::KEY_EDGE), 0u);
        write(regmap::KEY_MASK, 4);
        delay = sc_core::SC_ZERO_TIME;
        wait(10, sc_core::SC_US);
        now([this] { fabric.in.key_n = 0xf; });
        wait(1, sc_core::SC_US);
        EXPECT_EQ(read(regmap::KEY_EDGE), 4u);
        EXPECT_EQ(fabric.interrupts(), 1u << (73 - 72));
    });
}

TEST_F(FpgaTest, WritesAndReadsAnyLengthAtAnyAlignment) {
    run([this] {
        std::mt19937 random{1};
        std::vector<std::uint8_t> row(640), back(640);
        access(cpu.h2f, tlm::TLM_WRITE_COMMAND, ONCHIP + 5 * 1024, row.data(), 640);
        for (int i = 0; i < 300; ++i) {
            const auto at = static_cast<unsigned>(random() % 640);
            const auto bytes = 1 + static_cast<unsigned>(random() % (640 - at));
            for (unsigned b = 0; b < bytes; ++b) row[at + b] = static_cast<std::uint8_t>(random());
            ASSERT_EQ(access(cpu.h2f, tlm::TLM_WRITE_COMMAND, ONCHIP + 5 * 1024 + at,
                             row.data() + at, bytes),
                      tlm::TLM_OK_RESPONSE);
            const auto from = static_cast<unsigned>(random() % 640);
            const auto count = 1 + static_cast<unsigned>(random() % (640 - from));
            ASSERT_EQ(access(cpu.h2f, tlm::TLM_READ_COMMAND, ONCHIP + 5 * 1024 + from, back.data(),
                             count),
                      tlm::TLM_OK_RESPONSE);
            ASSERT_EQ(std::memcmp(back.data(), row.data() + from, count), 0)
                << "from " << from << " bytes " << count;
        }
    });
}

// As the processor and its DMA controller do, between which SystemC's events come.
TEST_F(FpgaTest, CarriesOneTransactionOfABridgeAfterTheOther) {
    run([this] {
        std::vector<std::uint8_t> row(640), back(640);
        std::iota(row.begin(), row.end(), std::uint8_t{0});
        std::uint32_t before = 0x12345678, after = 0;
        access(cpu.h2f, tlm::TLM_WRITE_COMMAND, ONCHIP + 8192, &before, 4);
        sc_core::sc_event written;
        sc_core::sc_spawn([&] {
            sc_time own;
            access(cpu.h2f, tlm::TLM_WRITE_COMMAND, ONCHIP, row.data(), 640, own);
            written.notify();
        });
        sc_core::sc_spawn([] {
            for (;;) sc_core::wait(1, sc_core::SC_US);
        });
        wait(3, sc_core::SC_US);
        EXPECT_TRUE(bridges.is_busy());
        EXPECT_EQ(access(cpu.h2f, tlm::TLM_READ_COMMAND, ONCHIP + 8192, &after, 4),
                  tlm::TLM_OK_RESPONSE);
        EXPECT_EQ(after, before);
        EXPECT_FALSE(bridges.is_busy());
        access(cpu.h2f, tlm::TLM_READ_COMMAND, ONCHIP, back.data(), 640);
        EXPECT_EQ(back, row);
    });
}

TEST_F(FpgaTest, AnswersEachAddressOfItsBridges) {
    run([this] {
        std::uint32_t value = 1;
        EXPECT_EQ(access(cpu.lw, tlm::TLM_READ_COMMAND, 0x1ff000, &value, 4), tlm::TLM_OK_RESPONSE);
        EXPECT_EQ(access(cpu.h2f, tlm::TLM_WRITE_COMMAND, 0x04000000, &value, 4),
                  tlm::TLM_OK_RESPONSE);
        EXPECT_EQ(read(regmap::SYSID_ID), 0x44453153u);
    });
}

TEST_F(FpgaTest, RefusesPayloadsThatAreNoMemoryAccess) {
    run([this] {
        std::uint32_t value = 1;
        EXPECT_EQ(access(cpu.lw, tlm::TLM_IGNORE_COMMAND, 0, &value, 4),
                  tlm::TLM_COMMAND_ERROR_RESPONSE);
        EXPECT_EQ(access(cpu.lw, tlm::TLM_READ_COMMAND, 0, &value, 0),
                  tlm::TLM_BURST_ERROR_RESPONSE);
        tlm::tlm_generic_payload tx;
        std::uint8_t enables[4] = {0xff, 0, 0, 0};
        tx.set_command(tlm::TLM_WRITE_COMMAND);
        tx.set_data_ptr(reinterpret_cast<unsigned char*>(&value));
        tx.set_data_length(4);
        tx.set_streaming_width(4);
        tx.set_byte_enable_ptr(enables);
        tx.set_byte_enable_length(4);
        cpu.lw->b_transport(tx, delay);
        EXPECT_EQ(tx.get_response_status(), tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
    });
}

TEST_F(FpgaTest, TakesTheTimeThatItsClocksTake) {
    run([this] {
        read(regmap::SYSID_ID);
        EXPECT_GE(delay, sc_time(4 * 40, sc_core::SC_NS));
        EXPECT_LE(delay, sc_time(20 * 40, sc_core::SC_NS));
        delay = sc_core::SC_ZERO_TIME;
        wait(1, sc_core::SC_MS);
        std::vector<std::uint8_t> row(640);
        const sc_time begin = sc_core::sc_time_stamp();
        access(cpu.h2f, tlm::TLM_WRITE_COMMAND, ONCHIP, row.data(), 640);
        const sc_time took = sc_core::sc_time_stamp() + delay - begin;
        EXPECT_GE(took, sc_time(160 * 40, sc_core::SC_NS));  // one word per clock at best
        EXPECT_LE(took, sc_time(160 * 40 * 2, sc_core::SC_NS));
    });
}

TEST_F(FpgaTest, RunsOneClockForEvery40Nanoseconds) {
    run([this] {
        wait(10, sc_core::SC_MS);
        fpga.catch_up();
        EXPECT_EQ(fabric.clocks(), 250'000u);
        EXPECT_EQ(pins.samples, 250'000u);
    });
}

TEST_F(FpgaTest, GivesTheKeypadsPinsToAnEnabledScannerAlone) {
    const auto jp1 = [](const sim::HeaderMasks& both) { return sim::bits_of_pins(both[0]); };
    run([&] {
        write(regmap::JP1_DIR, 0x1f0);
        write(regmap::JP1_DATA, 0x1a0);
        EXPECT_EQ(jp1(pins.header.enable), 0x1f0u);
        EXPECT_EQ(jp1(pins.header.levels), 0x1a0u);
        write(regmap::KEYPAD_CONTROL, 1);
        const std::uint32_t column = jp1(pins.header.enable) & 0xff;
        EXPECT_TRUE(column == 0x80 || column == 0x40 || column == 0x20 || column == 0x10);
        EXPECT_EQ(jp1(pins.header.enable) & ~0xffu, 0x100u);
        EXPECT_EQ(jp1(pins.header.levels), 0x100u) << "the scanner only pulls low";
        EXPECT_EQ(read(regmap::JP1_DIR), 0x1f0u) << "JP1's registers stay";
        write(regmap::KEYPAD_CONTROL, 0);
        EXPECT_EQ(jp1(pins.header.enable), 0x1f0u);
        EXPECT_EQ(jp1(pins.header.levels), 0x1a0u);
    });
}

// Two FPGAs, one of which has its memories mapped.
class MappedMemory : public FpgaTest {
protected:
    Pins other_pins;
    sim::Fabric other_fabric{other_pins};
    sim::FpgaChip other_fpga{"other_fpga", other_pins, other_fabric};
    sim::FpgaBridges mapped{"mapped", other_fpga, sim::FpgaBridges::Bursts::LONG};
    Initiator other{"other"};

    void run_both(std::function<void()> body) {
        other_fabric.set_memory(sim::Fabric::Memory::MAPPED, other_pins.chip.bytes());
        other.lw.bind(mapped.lw);
        other.h2f.bind(mapped.h2f);
        other.body = [] { sc_core::wait(sc_time(1000, sc_core::SC_SEC)); };  // it has no program
        run(std::move(body));
    }
    // The same access to both, at the same time; the clocks that it took each.
    struct Took {
        double bridged, mapped;
    };
    double clocks_of(tlm_utils::simple_initiator_socket<Initiator>& socket,
                     tlm::tlm_command command, std::uint32_t address, void* data, unsigned bytes) {
        const sc_time begin = sc_core::sc_time_stamp();
        delay = sc_core::SC_ZERO_TIME;
        access(socket, command, address, data, bytes);
        return (sc_core::sc_time_stamp() + delay - begin) / sc_time{40, sc_core::SC_NS};
    }
    Took both(tlm::tlm_command command, std::uint32_t address, std::uint8_t* data,
              std::uint8_t* other_data, unsigned bytes) {
        wait(sc_time(10, sc_core::SC_US));
        const double mapped_takes = clocks_of(other.h2f, command, address, other_data, bytes);
        return {clocks_of(cpu.h2f, command, address, data, bytes), mapped_takes};
    }
};

TEST_F(MappedMemory, HoldsAndTakesWhatTheVerilogDoes) {
    run_both([this] {
        wait(1, sc_core::SC_MS);
        std::mt19937 random{1};
        int slower = 0;  // where the screen or a refresh had priority
        for (int i = 0; i < 2000; ++i) {
            const std::uint32_t memory = random() % 2 ? ONCHIP : SDRAM;
            const auto bytes =
                static_cast<unsigned>(random() % 3 ? 1 << random() % 3 : 1 + random() % 64);
            const auto at = static_cast<std::uint32_t>(memory + random() % 2048 / bytes * bytes);
            std::uint8_t one[64], two[64];
            for (unsigned b = 0; b < bytes; ++b)
                one[b] = two[b] = static_cast<std::uint8_t>(random());
            const bool write = random() % 2;
            const auto took =
                both(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND, at, one, two, bytes);
            ASSERT_EQ(std::memcmp(one, two, bytes), 0) << "at " << at << " bytes " << bytes;
            if (memory == ONCHIP && write) {
                ASSERT_EQ(took.bridged, took.mapped);
            }
            ASSERT_GE(took.bridged, took.mapped - 1) << write << " bytes " << bytes;
            ASSERT_LE(took.bridged, took.mapped + 20) << write << " bytes " << bytes;
            slower += took.bridged > took.mapped + 2;
        }
        EXPECT_LT(slower, 200);
    });
    EXPECT_EQ(pins.chip.violations(), 0u);
}

}  // namespace
