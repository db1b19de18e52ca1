// The HPS models on the bus: decode, memory, global timer, UART, and the answers to wrong accesses.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>

#include "sim/hps/bus.h"
#include "sim/hps/global_timer.h"
#include "sim/hps/memory.h"
#include "sim/hps/uart.h"

namespace {

using sc_core::SC_NS;
using sc_core::sc_time;

// Of the UART; IIR is FCR when it is written, RBR is THR.
constexpr std::uint32_t RBR = 0xFFC02000, IER = 0xFFC02004, IIR = 0xFFC02008, FCR = IIR,
                        LSR = 0xFFC02014;

// A processor's socket, a bus, and three targets.
struct System : sc_core::sc_module {
    std::string printed;
    tlm_utils::simple_initiator_socket<System> cpu{"cpu"};
    sim::Bus bus{"bus"};
    sim::Memory memory{"memory", 1u << 20, sc_time{60, SC_NS}};
    sim::GlobalTimer timer{"timer"};
    bool uart_line = false;
    sim::Uart uart{"uart", [this](char c) { printed += c; }, [this](bool up) { uart_line = up; }};

    explicit System(const sc_core::sc_module_name& name) : sc_module{name} {
        cpu.bind(bus.socket);
        bus.window("memory", 0x00000000, 1u << 20).bind(memory.socket);
        bus.window("timer", 0xFFFEC200, 0x100).bind(timer.socket);
        bus.window("uart", 0xFFC02000, 0x1000).bind(uart.socket);
    }
};

// Two windows, the first of them at 0x1000 - 0x1FFF.
struct Overlapping : sc_core::sc_module {
    sim::Bus bus{"bus"};

    Overlapping(const sc_core::sc_module_name& name, std::uint32_t base, std::uint32_t size)
        : sc_module{name} {
        bus.window("a", 0x1000, 0x1000);
        bus.window("b", base, size);
    }
};

// Requests the switch of a window.
struct Gated : sc_core::sc_module {
    sim::Bus bus{"bus"};

    Gated(const sc_core::sc_module_name& name, const std::string& window) : sc_module{name} {
        bus.window("h2f", 0x1000, 0x1000);
        bus.window("lw", 0x2000, 0x1000);
        bus.gate(window)(false);
    }
};

class BusDeathTest : public ::testing::Test {};

class Hps : public ::testing::Test {
protected:
    System system{"system"};
    sim::Bus& bus = system.bus;
    sc_time delay;

    void SetUp() override { sc_core::sc_start(sc_core::SC_ZERO_TIME); }
    static void pass(double us) { sc_core::sc_start(sc_time{us, sc_core::SC_US}); }
    tlm::tlm_response_status access(tlm::tlm_command command, std::uint64_t address, void* data,
                                    unsigned bytes) {
        tlm::tlm_generic_payload tx;
        tx.set_command(command);
        tx.set_address(address);
        tx.set_data_ptr(static_cast<unsigned char*>(data));
        tx.set_data_length(bytes);
        tx.set_streaming_width(bytes);
        system.cpu->b_transport(tx, delay);
        EXPECT_EQ(tx.get_address(), address) << "the bus left its own address in the payload";
        return tx.get_response_status();
    }
    std::uint32_t read(std::uint32_t address) {
        std::uint32_t value = 0xdeadbeef;
        EXPECT_EQ(access(tlm::TLM_READ_COMMAND, address, &value, 4), tlm::TLM_OK_RESPONSE);
        return value;
    }
    void write(std::uint32_t address, std::uint32_t value) {
        EXPECT_EQ(access(tlm::TLM_WRITE_COMMAND, address, &value, 4), tlm::TLM_OK_RESPONSE);
    }
};

TEST_F(Hps, MemoryRemembersBytesAcrossItsPages) {
    std::array<std::uint8_t, 64> out{}, in{};
    for (unsigned i = 0; i < out.size(); ++i) out[i] = static_cast<std::uint8_t>(i * 3 + 1);
    EXPECT_EQ(access(tlm::TLM_WRITE_COMMAND, 0xFFE3, out.data(), 64), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, 0xFFE3, in.data(), 64), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(in, out);
    EXPECT_EQ(read(0x50000), 0u);
    EXPECT_EQ(delay, sc_time(180, SC_NS));
}

TEST_F(Hps, AnUnownedAddressIsACountedError) {
    std::uint32_t value = 0;
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, 0x80000000, &value, 4),
              tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(bus.counts().errors, 1u);
}

TEST_F(Hps, AnAccessThatLeavesItsWindowIsAnAddressError) {
    std::array<std::uint8_t, 16> data{};
    EXPECT_EQ(access(tlm::TLM_WRITE_COMMAND, (1u << 20) - 8, data.data(), 16),
              tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, 0x1'0000'0000, data.data(), 4),
              tlm::TLM_ADDRESS_ERROR_RESPONSE);
}

TEST_F(Hps, RegistersRefuseAccessesThatAreNotOneAlignedWord) {
    std::array<std::uint8_t, 8> data{};
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, 0xFFFEC202, data.data(), 4),
              tlm::TLM_BURST_ERROR_RESPONSE);
    EXPECT_EQ(access(tlm::TLM_READ_COMMAND, 0xFFFEC200, data.data(), 2),
              tlm::TLM_BURST_ERROR_RESPONSE);
    EXPECT_EQ(access(tlm::TLM_WRITE_COMMAND, 0xFFFEC200, data.data(), 8),
              tlm::TLM_BURST_ERROR_RESPONSE);
}

TEST_F(Hps, CountsReadsWritesAndBursts) {
    std::array<std::uint8_t, 64> data{};
    read(0x100);
    write(0x100, 1);
    write(0x104, 1);
    access(tlm::TLM_WRITE_COMMAND, 0, data.data(), 64);
    EXPECT_EQ(bus.counts().reads, 1u);
    EXPECT_EQ(bus.counts().writes, 2u);
    EXPECT_EQ(bus.counts().bursts, 1u);
    EXPECT_EQ(bus.counts().errors, 0u);
}

TEST_F(Hps, TheGlobalTimerCountsAt200MHzOnceEnabled) {
    sc_core::sc_start(1, sc_core::SC_US);
    EXPECT_EQ(read(0xFFFEC200), 0u);
    write(0xFFFEC208, 1);
    delay = sc_core::SC_ZERO_TIME;
    const std::uint32_t before = read(0xFFFEC200);
    sc_core::sc_start(1, sc_core::SC_MS);
    delay = sc_core::SC_ZERO_TIME;
    EXPECT_EQ(read(0xFFFEC200) - before, 200'000u);
}

TEST_F(Hps, TheGlobalTimerHas64Bits) {
    write(0xFFFEC200, 0xffffff00);
    write(0xFFFEC204, 7);
    write(0xFFFEC208, 1);
    sc_core::sc_start(10, sc_core::SC_US);
    EXPECT_EQ(read(0xFFFEC204), 8u);
}

TEST_F(Hps, TheUartGivesWhatIsTypedACharacterPerMillisecond) {
    write(FCR, 1);
    system.uart.receive("go");
    pass(999);
    EXPECT_EQ(read(LSR) & 1, 0u);
    pass(2);
    EXPECT_EQ(read(LSR) & 1, 1u);
    pass(1001);
    EXPECT_EQ(read(RBR), 'g');
    EXPECT_EQ(read(RBR), 'o');
    EXPECT_EQ(read(LSR) & 1, 0u);
    EXPECT_EQ(read(RBR), 0u);
}

TEST_F(Hps, TheUartInterruptsWhileACharacterWaits) {
    write(IER, 1);
    EXPECT_FALSE(system.uart_line);
    system.uart.receive("x");
    pass(1001);
    EXPECT_TRUE(system.uart_line);
    EXPECT_EQ(read(IIR) & 0xF, 4u);
    EXPECT_EQ(read(RBR), 'x');
    EXPECT_FALSE(system.uart_line);
    EXPECT_EQ(read(IIR) & 0xF, 1u);
}

TEST_F(Hps, TheUartReportsAnOverflowOnce) {
    write(FCR, 0);
    system.uart.receive("ab");
    pass(2001);
    EXPECT_EQ(read(LSR) & 3, 3u);
    EXPECT_EQ(read(LSR) & 3, 1u);
    EXPECT_EQ(read(RBR), 'a');
    write(FCR, 1);
    system.uart.receive(std::string(129, 'c'));
    pass(129'001);
    EXPECT_EQ(read(LSR) & 2, 2u);
    for (int i = 0; i < 128; ++i) EXPECT_EQ(read(RBR), 'c');
    EXPECT_EQ(read(LSR) & 3, 0u);
}

TEST_F(Hps, ASentByteKeepsTheReceivedOnes) {
    system.uart.receive("x");
    pass(1001);
    std::uint8_t byte = 'h';
    EXPECT_EQ(access(tlm::TLM_WRITE_COMMAND, RBR, &byte, 1), tlm::TLM_OK_RESPONSE);
    pass(87);
    EXPECT_EQ(system.printed, "h");
    EXPECT_EQ(read(RBR), 'x');
}

TEST_F(BusDeathTest, RefusesTwoWindowsThatOverlap) {
    EXPECT_DEATH(Overlapping("two", 0x1800, 0x1000), "");  // SystemC prints to stdout
    EXPECT_DEATH(Overlapping("two", 0x0000, 0x8000), "");  // around the other
}

TEST_F(BusDeathTest, RefusesAnUnknownWindowAndNamesTheKnownOnes) {
    sc_core::sc_report_handler::set_actions(sc_core::SC_FATAL, sc_core::SC_THROW);
    try {
        Gated("one", "lwh2f");
        ADD_FAILURE() << "it was taken";
    } catch (const sc_core::sc_report& report) {
        EXPECT_STREQ(report.get_msg(), "no window lwh2f; there are: h2f, lw");
    }
}

TEST_F(BusDeathTest, SwitchesAWindowThatItHas) { EXPECT_NO_THROW(Gated("one", "lw")); }

TEST_F(BusDeathTest, TakesWindowsThatTouch) { EXPECT_NO_THROW(Overlapping("two", 0x2000, 0x1000)); }

}  // namespace
