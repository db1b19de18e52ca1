// gdb_test.cpp - GDB's packets: their format, and the answers of a mock processor.
#include "sim/debug/arm_registers.h"
#include "sim/debug/gdb_commands.h"
#include "sim/debug/gdb_packet.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <vector>

namespace {

using sim::GdbEvent;
using sim::GdbNext;
using sim::GdbPoint;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

// ---- The envelope -------------------------------------------------------------------------------

struct Reading {
    std::vector<std::string> packets;
    unsigned corrupt = 0, repeat = 0, interrupt = 0;
};

Reading read(const std::string& bytes) {
    sim::GdbPacketReader reader;
    Reading reading;
    for (const char byte : bytes) {
        const auto event = reader.feed(byte);
        if (!event) continue;
        if (event == GdbEvent::PACKET) reading.packets.push_back(reader.text());
        reading.corrupt += event == GdbEvent::CORRUPT;
        reading.repeat += event == GdbEvent::REPEAT;
        reading.interrupt += event == GdbEvent::INTERRUPT;
    }
    return reading;
}

// The checksums are those of sessions recorded with gdb 13 and of its manual.
TEST(GdbPacket, IsReadWhereItsChecksumIsRight) {
    EXPECT_THAT(read("+$?#3f$qC#b4+$vCont?#49").packets, ElementsAre("?", "qC", "vCont?"));
}

TEST(GdbPacket, IsWrittenWithItsChecksum) {
    EXPECT_EQ(sim::gdb_packet("OK"), "$OK#9a");
    EXPECT_EQ(sim::gdb_packet("m154,4"), "$m154,4#67");
    EXPECT_EQ(sim::gdb_packet(""), "$#00");
}

TEST(GdbPacket, IsAskedForAgainWhereItsChecksumIsWrong) {
    EXPECT_EQ(read("$?#3e").corrupt, 1u);
    EXPECT_EQ(read("$?#zz").corrupt, 1u);
    EXPECT_EQ(read("$?#3e$qC#b4").packets, std::vector<std::string>{"qC"});
}

TEST(GdbPacket, LongerThanTheLimitIsRefusedAndTheNextOneRead) {
    const std::string longest(sim::GDB_PACKET_BYTES, 'a'), longer = longest + "a";
    EXPECT_EQ(read(sim::gdb_packet(longest)).packets.size(), 1u);
    const Reading reading = read(sim::gdb_packet(longer) + "$qC#b4");
    EXPECT_EQ(reading.corrupt, 1u);
    EXPECT_THAT(reading.packets, ElementsAre("qC"));
}

TEST(GdbPacket, KeepsBytesThatHaveAMeaningOfTheirOwn) {
    const std::string text = "a$b#c}d*e\x03 f\xff+-";
    EXPECT_THAT(read(sim::gdb_packet(text)).packets, ElementsAre(text));
    EXPECT_EQ(read(sim::gdb_packet(text)).interrupt, 0u);
}

TEST(GdbPacket, CtrlCAndRepeatCountBetweenPackets) {
    const Reading reading = read("\x03-$?#3f-\x03");
    EXPECT_EQ(reading.interrupt, 2u);
    EXPECT_EQ(reading.repeat, 2u);
    EXPECT_THAT(reading.packets, ElementsAre("?"));
}

// ---- The answers --------------------------------------------------------------------------------

struct FakeTarget : sim::GdbTarget {
    static constexpr std::uint32_t BASE = 0x1000;
    std::array<std::uint64_t, sim::arm_register::COUNT> regs{};
    std::array<std::uint8_t, 256> memory{};  // at BASE; nothing else answers
    std::vector<GdbPoint> points;
    unsigned written = 0;

    std::size_t here(std::uint32_t address, std::size_t bytes) const {
        if (address < BASE || address >= BASE + memory.size()) return 0;
        return std::min<std::size_t>(bytes, BASE + memory.size() - address);
    }
    const sim::GdbRegisters& registers() const override { return sim::arm_registers(); }
    std::uint64_t reg(unsigned number) override { return regs.at(number); }
    bool set_reg(unsigned number, std::uint64_t value) override {
        if (number == fixed) return false;
        regs.at(number) = value;
        return true;
    }
    unsigned fixed = sim::arm_register::COUNT;
    std::size_t read(std::uint32_t address, void* data, std::size_t bytes) override {
        const std::size_t count = here(address, bytes);
        if (count) std::memcpy(data, &memory[address - BASE], count);
        return count;
    }
    std::size_t write(std::uint32_t address, const void* data, std::size_t bytes) override {
        const std::size_t count = here(address, bytes);
        if (count) std::memcpy(&memory[address - BASE], data, count);
        ++written;
        return count;
    }
    void insert(const GdbPoint& point) override { points.push_back(point); }
    void remove(const GdbPoint& point) override {
        points.erase(std::remove(points.begin(), points.end(), point), points.end());
    }
    std::string stop_reply() override { return "T05thread:1;"; }
    std::vector<sim::GdbThread> all{{1, "", ""}};
    std::uint32_t chosen = 1;
    std::vector<sim::GdbThread> threads() override { return all; }
    std::uint32_t chosen_thread() override { return chosen; }
    void choose_thread(std::uint32_t thread) override { chosen = thread ? thread : all[0].number; }
    std::uint32_t moved_by = 0;
    std::uint32_t displacement() override { return moved_by; }
    std::string monitor(std::string_view command) override {
        return "<" + std::string{command} + ">";
    }
};

class GdbCommands : public ::testing::Test {
protected:
    FakeTarget target;
    std::string answer(const std::string& packet) { return sim::gdb_answer(target, packet).text; }
    GdbNext next(const std::string& packet) { return sim::gdb_answer(target, packet).next; }
    // The one that is stepped, 0 being the one that has stopped; -1: none is.
    int stepped(const std::string& packet) {
        const sim::GdbAnswer given = sim::gdb_answer(target, packet);
        return given.next == GdbNext::STEP ? static_cast<int>(given.thread) : -1;
    }
};

TEST_F(GdbCommands, RegistersAreLittleEndianAndOfTheDescribedWidth) {
    target.regs[3] = 0x11223344;
    target.regs[17] = 0x1122334455667788;
    EXPECT_EQ(answer("p3"), "44332211");
    EXPECT_EQ(answer("p11"), "8877665544332211");
    const std::string all = answer("g");
    EXPECT_EQ(all.size(), 2 * (17 * 4 + 32 * 8 + 4u));
    EXPECT_EQ(all.substr(3 * 8, 8), "44332211");
}

TEST_F(GdbCommands, WritesOneRegisterOrAll) {
    EXPECT_EQ(answer("P10=d3010000"), "OK");
    EXPECT_EQ(target.regs[16], 0x1d3u);
    FakeTarget other;
    EXPECT_EQ(sim::gdb_answer(other, "G" + answer("g")).text, "OK");
    EXPECT_EQ(other.regs, target.regs);
}

TEST_F(GdbCommands, ARegisterThatCannotBeWrittenIsAnError) {
    target.fixed = 16;
    EXPECT_EQ(answer("P10=d3010000"), "E01");
    std::string all = answer("g");
    all.replace(16 * 8, 8, "ffffffff");
    EXPECT_EQ(answer("G" + all), "OK") << "the others have their values";
    EXPECT_EQ(target.regs[16], 0u);
}

TEST_F(GdbCommands, TheDescriptionComesInPieces) {
    std::string xml;
    for (unsigned offset = 0;; offset += 100) {
        char packet[80];
        std::snprintf(packet, sizeof packet, "qXfer:features:read:target.xml:%x,%x", offset, 100);
        const std::string part = answer(packet);
        ASSERT_FALSE(part.empty());
        xml += part.substr(1);
        if (part[0] == 'l') break;
        ASSERT_EQ(part[0], 'm');
    }
    EXPECT_THAT(xml, HasSubstr("<feature name=\"org.gnu.gdb.arm.core\"><reg name=\"r0\""));
    EXPECT_THAT(xml, HasSubstr("</feature><feature name=\"org.gnu.gdb.arm.vfp\">"));
    EXPECT_THAT(xml, HasSubstr("name=\"d31\""));
    EXPECT_THAT(xml, HasSubstr("</target>"));
}

TEST_F(GdbCommands, MemoryIsReadAndWritten) {
    EXPECT_EQ(answer("M1010,3:0102ff"), "OK");
    EXPECT_EQ(answer("m1010,4"), "0102ff00");
    EXPECT_EQ(answer("X1011,2:#}"), "OK");
    EXPECT_EQ(answer("m1010,3"), "01237d");
}

TEST_F(GdbCommands, MemoryThatNobodyAnswersForIsAnError) {
    EXPECT_EQ(answer("m0,4"), "E01");
    EXPECT_EQ(answer("M2000,1:00"), "E01");
    EXPECT_EQ(answer("m10fe,4"), "0000") << "as far as it goes";
    EXPECT_EQ(answer("m1000,ffffffffffffffff").size(), 512u);
}

TEST_F(GdbCommands, PointsAreSetAndCleared) {
    EXPECT_EQ(answer("Z0,1000,4"), "OK");
    EXPECT_EQ(answer("Z2,2000,8"), "OK");
    EXPECT_EQ(answer("Z3,2000,1"), "OK");
    EXPECT_EQ(answer("Z4,2000,2"), "OK");
    EXPECT_THAT(
        target.points,
        ElementsAre(GdbPoint{GdbPoint::BREAK, 0x1000, 4}, GdbPoint{GdbPoint::WRITE, 0x2000, 8},
                    GdbPoint{GdbPoint::READ, 0x2000, 1}, GdbPoint{GdbPoint::ACCESS, 0x2000, 2}));
    for (const char* packet : {"z1,1000,4", "z2,2000,8", "z3,2000,1", "z4,2000,2"}) answer(packet);
    EXPECT_THAT(target.points, IsEmpty());
    EXPECT_EQ(answer("Z5,1000,4"), "") << "a kind that there is not";
}

TEST_F(GdbCommands, GoOnStepLeaveAndEnd) {
    EXPECT_EQ(next("c"), GdbNext::CONTINUE);
    EXPECT_EQ(next("s"), GdbNext::STEP);
    EXPECT_EQ(next("C05;1234"), GdbNext::CONTINUE);
    EXPECT_EQ(target.regs[15], 0x1234u);
    EXPECT_EQ(next("vCont;s:1;c"), GdbNext::STEP);
    EXPECT_EQ(next("vCont;c"), GdbNext::CONTINUE);
    EXPECT_EQ(next("D"), GdbNext::DETACH);
    EXPECT_EQ(next("k"), GdbNext::KILL);
    EXPECT_EQ(next("vKill;1"), GdbNext::KILL);
}

TEST_F(GdbCommands, ThereIsOneThreadWithoutASystem) {
    EXPECT_EQ(answer("qfThreadInfo"), "m1");
    EXPECT_EQ(answer("qsThreadInfo"), "l");
    EXPECT_EQ(answer("qC"), "QC1");
    EXPECT_THAT(answer("qXfer:threads:read::0,fff"),
                EndsWith("<threads><thread id=\"1\"></thread></threads>"));
}

TEST_F(GdbCommands, ThreadsAreListedWithTheirNamesAndStates) {
    target.all = {{1, "main", "runs"}, {0x1f, "a<\"b\"&\xff", "waits for thread 1"}};
    EXPECT_THAT(answer("qSupported"), HasSubstr(";qXfer:threads:read+;"));
    EXPECT_EQ(answer("qfThreadInfo"), "m1,1f");
    EXPECT_THAT(
        answer("qXfer:threads:read::0,fff"),
        AllOf(StartsWith("l<?xml"), HasSubstr("<thread id=\"1\" name=\"main\">runs</thread>"),
              HasSubstr("<thread id=\"1f\" name=\"a&#60;&#34;b&#34;&#38;?\">waits for")));
    EXPECT_EQ(answer("qXfer:threads:read::2,3"), "mxml");
}

TEST_F(GdbCommands, AThreadIsChosenForRegistersAndMemory) {
    target.all = {{1, "", ""}, {0x1f, "", ""}};
    EXPECT_EQ(answer("Hg1f"), "OK");
    EXPECT_EQ(target.chosen, 0x1fu);
    EXPECT_EQ(answer("qC"), "QC1f");
    EXPECT_EQ(answer("Hg2"), "E01") << "is no thread";
    EXPECT_EQ(answer("Hc1"), "OK") << "has no effect";
    EXPECT_EQ(target.chosen, 0x1fu);
    EXPECT_EQ(answer("Hg0"), "OK");
    EXPECT_EQ(target.chosen, 1u);
    EXPECT_EQ(answer("Hc-1"), "OK");
    EXPECT_EQ(answer("T1f"), "OK");
    EXPECT_EQ(answer("T2"), "E01");
}

TEST_F(GdbCommands, TheFirstActionForAThreadIsItsOwn) {
    target.all = {{1, "", ""}, {0x1f, "", ""}};
    EXPECT_EQ(stepped("vCont;s:1f;c"), 0x1f);
    EXPECT_EQ(stepped("vCont;c:1;s:1f"), 0x1f);
    EXPECT_EQ(stepped("vCont;S05:1;c"), 1);
    EXPECT_EQ(stepped("vCont;s"), 0);
    EXPECT_EQ(stepped("vCont;s:-1"), 0);
    EXPECT_EQ(stepped("vCont;c;s:1f"), -1);
    EXPECT_EQ(next("vCont;c:1f"), GdbNext::CONTINUE);
    EXPECT_EQ(answer("vCont;s:2"), "E01") << "is no thread";
}

TEST_F(GdbCommands, HaveTheDisplacementOfAPositionIndependentProgram) {
    EXPECT_EQ(answer("qOffsets"), "");
    target.moved_by = 0x400000;
    EXPECT_EQ(answer("qOffsets"), "TextSeg=400000");
}

TEST_F(GdbCommands, MonitorSpeaksInHex) { EXPECT_EQ(answer("qRcmd,6869"), "3c68693e"); }

TEST_F(GdbCommands, WhatIsNotKnownIsAnsweredEmpty) {
    for (const char* packet : {"", "vMustReplyEmpty", "qTStatus", "R00", "!", "i", "\xff\x01"})
        EXPECT_EQ(answer(packet), "") << packet;
}

TEST_F(GdbCommands, AnInvalidCommandIsAnErrorAndChangesNothing) {
    for (const char* packet : {"m",
                               "m1000",
                               "m1000,",
                               "m1000,4x",
                               "m100000000,4",
                               "M1000,2:01",
                               "M1000,1:0g",
                               "M1000,1",
                               "X1000,2:a",
                               "p",
                               "p32",
                               "pffffffff",
                               "P3",
                               "P3=11",
                               "P3=1122334455",
                               "G00",
                               "Gzz",
                               "Z",
                               "Z0",
                               "Z0,1000",
                               "Z2,1000,0",
                               "z9z,1,1",
                               "cxyz",
                               "vCont;",
                               "vCont;t",
                               "vCont;c;x",
                               "vCont;c1",
                               "vCont;s:",
                               "vCont;s:z",
                               "vCont;S:1",
                               "H",
                               "Hx1",
                               "Hg",
                               "Hgx",
                               "T",
                               "qXfer:threads:read::0",
                               "qRcmd,6",
                               "qXfer:features:read:target.xml:0",
                               "qXfer:features:read:target.xml:ffff,1"})
        EXPECT_EQ(answer(packet), "E01") << packet;
    EXPECT_EQ(target.written, 0u);
    EXPECT_THAT(target.points, IsEmpty());
    EXPECT_EQ(target.regs, FakeTarget{}.regs);
}

// Mutations of real packets: none may crash, hang, or have an answer longer than a packet.
TEST_F(GdbCommands, AnyBytesAreSurvived) {
    const std::vector<std::string> seeds{"g",
                                         "p3",
                                         "P3=11223344",
                                         "m1000,40",
                                         "M1000,2:0102",
                                         "X1000,2:ab",
                                         "Z2,1000,4",
                                         "z2,1000,4",
                                         "vCont;s:1;c",
                                         "qSupported:swbreak+",
                                         "qRcmd,6869",
                                         "C05;1000",
                                         "Hg0",
                                         "vCont;C05:1;s:-1;c",
                                         "qXfer:threads:read::0,fff",
                                         "qXfer:features:read:target.xml:0,ffb",
                                         "qfThreadInfo",
                                         "?",
                                         "D;1",
                                         "T1"};
    std::mt19937 random{4};
    sim::GdbPacketReader reader;
    unsigned packets = 0;
    for (unsigned round = 0; round < 200'000; ++round) {
        std::string text = seeds[random() % seeds.size()];
        for (unsigned change = random() % 4; change > 0; --change) {
            const std::size_t at = random() % (text.size() + 1);
            switch (random() % 3) {
                case 0: text.insert(at, 1, static_cast<char>(random())); break;
                case 1: text.erase(at, 1 + random() % 3); break;
                default: text.insert(at, text.substr(0, random() % 16)); break;
            }
        }
        std::string bytes = sim::gdb_packet(text);
        if (random() % 4 == 0) bytes[random() % bytes.size()] = static_cast<char>(random());
        for (const char byte : bytes) {
            if (reader.feed(byte) != GdbEvent::PACKET) continue;
            ++packets;
            ASSERT_LE(answer(reader.text()).size(), sim::GDB_PACKET_BYTES);
        }
    }
    EXPECT_GT(packets, 100'000u);
}

}  // namespace
