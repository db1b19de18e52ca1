// The processor's bridges into the FPGA: random bursts, posted or not, at slaves of AXI3 (ARM IHI
// 0022D) that stall, answer posted writes in any order, and refuse some; against a memory of bytes.

#include "Vhps_bridges_bench.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <tuple>
#include <vector>

#include "sim/project/runtime/bridge.h"
#include "tb/ip/random_master.h"
#include "tb/ip/wide_port.h"

namespace {

using sim::BridgeBurst;
using sim::project::bridge_burst;
using sim::project::posted_writes;
using namespace sim::test;

constexpr unsigned FIXED = 0, INCR = 1, MOST_POSTED = 3;
using Memory = std::vector<std::uint8_t>;
// An ID, an address, a response.
using Refusal = std::tuple<unsigned, std::uint32_t, unsigned>;

// What a channel holds valid must stay as it is until it is taken.
class Held {
public:
    void look(const char* channel, bool valid, bool ready, std::vector<std::uint64_t> payload) {
        if (waits_) {
            EXPECT_TRUE(valid) << channel << " is valid no more, and was not taken";
            EXPECT_EQ(payload, payload_) << channel << " changes before it is taken";
        }
        waits_ = valid && !ready;
        payload_ = std::move(payload);
    }

private:
    bool waits_ = false;
    std::vector<std::uint64_t> payload_;
};

// A slave at bridge `n`: a memory.  What it refuses is written, or read, all the same.
class Slave {
public:
    Slave(Vhps_bridges_bench& top, unsigned n, unsigned width, std::mt19937& random)
        : top_{top}, n_{n}, width_{width}, random_{random}, memory(REGION) {}

    // Before the clock's edge.
    void drive() {
        put(top_.awready_i, 1, random_() % 2);
        put(top_.wready_i, 1, random_() % 2);
        put(top_.arready_i, 1, random_() % 2);
        answer_.reset();
        if (!done_.empty() && random_() % 8 == 0) answer_ = random_() % done_.size();
        // In order among those of one ID.
        while (answer_ && *answer_ > 0 && has_before(*answer_)) --*answer_;
        put(top_.bvalid_i, 1, answer_.has_value());
        if (answer_) put(top_.bid_i, 12, done_[*answer_].id);
        if (answer_) put(top_.bresp_i, 2, done_[*answer_].response);
        const bool reads = read_ && (reads_now_ || random_() % 2);
        reads_now_ = reads;
        put(top_.rvalid_i, 1, reads);
        if (!reads) return;
        put(top_.rid_i, 12, read_->id);
        put(top_.rresp_i, 2, read_->response);
        put(top_.rlast_i, 1, beat_ + 1 == read_->burst.beats);
        const std::uint32_t word = read_->burst.address_of(beat_) / width_ * width_;
        for (unsigned lane = 0; lane < width_; ++lane)
            set(&top_.rdata_i[0], 128 * n_ + 8 * lane, 8, memory[word + lane]);
    }

    // What the edge does, as the ports are before it.
    void look() {
        const Taken write =
            command(top_.awid_o, &top_.awaddr_o, top_.awlen_o, top_.awsize_o, top_.awburst_o);
        const Taken read =
            command(top_.arid_o, &top_.araddr_o, top_.arlen_o, top_.arsize_o, top_.arburst_o);
        const bool awvalid = bits(top_.awvalid_o, 1), arvalid = bits(top_.arvalid_o, 1),
                   wvalid = bits(top_.wvalid_o, 1), wlast = bits(top_.wlast_o, 1);
        const std::uint64_t strobes = top_.wstrb_o >> 16 * n_ & 0xFFFF;
        aw_.look("AW", awvalid, bits(top_.awready_i, 1), payload(write));
        ar_.look("AR", arvalid, bits(top_.arready_i, 1), payload(read));
        w_.look("W", wvalid, bits(top_.wready_i, 1),
                {get(&top_.wdata_o[0], 128 * n_, 64), get(&top_.wdata_o[0], 128 * n_ + 64, 64),
                 strobes, wlast});
        EXPECT_TRUE(bits(top_.bready_o, 1) && bits(top_.rready_o, 1));
        if (answer_) done_.erase(done_.begin() + static_cast<int>(*answer_));
        if (wvalid && bits(top_.wready_i, 1)) {
            EXPECT_EQ(bits(top_.wid_o, 12), write.id);
            words_.push_back({get(&top_.wdata_o[0], 128 * n_, 64),
                              get(&top_.wdata_o[0], 128 * n_ + 64, 64), strobes, wlast});
        }
        if (awvalid && bits(top_.awready_i, 1)) {
            EXPECT_FALSE(write_) << "two addresses of writes before their words";
            write_ = write;
        }
        take_words();
        if (reads_now_) end_beat();
        if (arvalid && bits(top_.arready_i, 1)) {
            EXPECT_TRUE(!read_ && !write_ && done_.empty()) << "a read overlaps";
            read_ = read;
        }
        if (!done_.empty()) most = std::max<std::size_t>(most, done_.size());
    }

private:
    struct Taken {
        Burst burst;
        unsigned id, response;
    };
    using Word = std::array<std::uint64_t, 4>;  // data, strobes, last

    template <class Port>
    void put(Port& port, unsigned wide, std::uint64_t value) {
        const std::uint64_t mask = ((std::uint64_t{1} << wide) - 1) << wide * n_;
        port = static_cast<Port>((port & ~mask) | value << wide * n_);
    }
    template <class Port>
    unsigned bits(const Port& port, unsigned wide) const {
        return static_cast<unsigned>(port >> wide * n_ & ((1u << wide) - 1));
    }
    bool has_before(std::size_t last) const {
        return std::any_of(done_.begin(), done_.begin() + static_cast<int>(last),
                           [&](const Taken& one) { return one.id == done_[last].id; });
    }

    Taken command(IData id, const QData* address, CData len, CData size, CData kind) const {
        const Burst burst{false,
                          static_cast<std::uint32_t>(*address >> 30 * n_ & 0x3FFFFFFF),
                          bits(len, 4) + 1,
                          bits(size, 3),
                          bits(kind, 2),
                          0};
        // Bits 12 and 13 of the address are the response.
        return {{false, burst.address % REGION, burst.beats, burst.size, burst.kind, 0},
                bits(id, 12),
                burst.address / REGION % 4};
    }
    static std::vector<std::uint64_t> payload(const Taken& one) {
        return {one.burst.address, one.burst.beats, one.burst.size,
                one.burst.kind,    one.id,          one.response};
    }

    // Words may come before their address.
    void take_words() {
        while (write_ && !words_.empty()) {
            const Burst& burst = write_->burst;
            const Word& word = words_.front();
            const std::uint32_t address = burst.address_of(beat_), size = 1u << burst.size;
            for (unsigned lane = 0; lane < 16; ++lane) {
                if (!(word[2] >> lane & 1)) continue;
                const std::uint32_t at = address / width_ * width_ + lane;
                EXPECT_TRUE(lane < width_ && at >= address && at < (address & ~(size - 1)) + size)
                    << "a strobe outside of the word";
                memory[at % REGION] = static_cast<std::uint8_t>(word[lane / 8] >> lane % 8 * 8);
            }
            EXPECT_EQ(word[3] != 0, beat_ + 1 == burst.beats) << "WLAST";
            words_.pop_front();
            ++beats;
            if (++beat_ < burst.beats) continue;
            beat_ = 0;
            done_.push_back(*std::exchange(write_, std::nullopt));
        }
    }
    void end_beat() {
        ++beats;
        reads_now_ = false;
        if (++beat_ < read_->burst.beats) return;
        beat_ = 0;
        read_.reset();
    }

    Vhps_bridges_bench& top_;
    const unsigned n_, width_;
    std::mt19937& random_;
    Held aw_, ar_, w_;
    std::optional<Taken> write_, read_;
    std::deque<Word> words_;
    unsigned beat_ = 0;
    std::deque<Taken> done_;  // writes that are not answered
    std::optional<std::size_t> answer_;
    bool reads_now_ = false;

public:
    Memory memory;
    std::uint64_t beats = 0;
    std::size_t most = 0;  // that were done and not answered
};

class HpsBridges : public testing::Test {
protected:
    void SetUp() override { posted_writes.clear(); }

    BridgeBurst random_burst() {
        const bool full = random() % 2;
        const unsigned width = full ? full_width : 4;
        BridgeBurst made{};
        made.full = full;
        made.write = random() % 4;
        while (1u << made.size < width) ++made.size;
        made.size = random() % (made.size + 1);
        made.kind = random() % 4 ? INCR : FIXED;
        made.beats = 1 + random() % 16;
        made.address = random() % (REGION - 256);
        made.posted = made.write && random() % 4;
        made.id = made.posted ? ++ids % 3 << 5 | 0xA : random() % 4096;
        Burst burst{made.write, made.address, made.beats, made.size, made.kind, 0};
        for (unsigned n = 0; n < made.beats; ++n) {
            const std::uint32_t at = burst.address_of(n), size = 1u << made.size,
                                end = (at & ~(size - 1)) + size;
            made.beat[n].address = at / width * width;
            for (std::uint32_t a = at; a < end; ++a)
                if (!made.write || random() % 4)
                    made.beat[n].strobes |= static_cast<std::uint16_t>(1u << a % width);
            for (auto& byte : made.beat[n].lanes) byte = static_cast<std::uint8_t>(random());
        }
        if (random() % 16 == 0) made.address += (random() % 3 + 1) * REGION;
        return made;
    }

    void write_expected(const BridgeBurst& burst) {
        for (unsigned n = 0; n < burst.beats; ++n)
            for (unsigned lane = 0; lane < 16; ++lane)
                if (burst.beat[n].strobes >> lane & 1)
                    expected[burst.full][burst.beat[n].address + lane] = burst.beat[n].lanes[lane];
    }

    void give(const BridgeBurst& burst) {
        bridge_burst = burst;
        top.request_i ^= burst.full ? 2 : 1;
    }

    void look_at_answer() {
        if (waits && top.answer_o == top.request_i) {
            const BridgeBurst& answer = bridge_burst;
            const unsigned response = waits->address / REGION % 4;
            EXPECT_EQ(answer.error, response);
            for (unsigned n = 0; n < waits->beats && !waits->write; ++n)
                for (unsigned lane = 0; lane < 16; ++lane)
                    if (waits->beat[n].strobes >> lane & 1) {
                        ASSERT_EQ(answer.beat[n].lanes[lane],
                                  expected[waits->full][waits->beat[n].address + lane]);
                    }
            waits.reset();
        }
        while (const auto refused = posted_writes.refused()) {
            const auto found = refusals.find({refused->id, refused->address, refused->error});
            ASSERT_NE(found, refusals.end()) << "a write that should not be refused";
            if (--found->second == 0) refusals.erase(found);
        }
    }

    // As sim/project/runtime/model.cpp gives them.
    void next() {
        if (posted_writes.count() && top.answer_o == top.request_i)
            if (const BridgeBurst* posted = posted_writes.next()) give(*posted);
        if (waits || random() % 3 == 0) return;
        if (!comes) comes = random_burst();
        const unsigned under_way = posted_writes.count();
        if (comes->posted ? under_way >= MOST_POSTED || posted_writes.has(comes->id) : under_way)
            return;
        if (comes->write) write_expected(*comes);
        if (comes->posted) {
            const unsigned response = comes->address / REGION % 4;
            if (response > 1) ++refusals[{comes->id, comes->address, response}];
            posted_writes.begin(*comes);
            if (top.answer_o == top.request_i) give(*posted_writes.next());
        } else {
            give(*(waits = comes));
        }
        comes.reset();
    }

    void play(unsigned width, std::uint64_t beats) {
        full_width = width;
        top.size_i = width == 4 ? 0 : width == 8 ? 1 : 2;
        slaves.emplace_back(top, 0, 4, random);
        slaves.emplace_back(top, 1, width, random);
        const auto done = [&] { return std::min(slaves[0].beats, slaves[1].beats); };
        std::uint64_t before = 0;
        for (unsigned clocks = 1; done() < beats && !HasFailure(); ++clocks) {
            if (clocks % 10'000 == 0) {
                ASSERT_GT(done(), before) << "a bridge stands still";
                before = done();
            }
            next();
            for (Slave& slave : slaves) slave.drive();
            top.clk_i = 0;
            top.eval();
            for (Slave& slave : slaves) slave.look();
            top.clk_i = 1;
            top.eval();
            look_at_answer();
        }
        EXPECT_GE(slaves[0].most, 2u) << "no posted writes overlap";
        EXPECT_GE(slaves[1].most, 2u) << "no posted writes overlap";
    }

    std::mt19937 random{1};
    Vhps_bridges_bench top;
    std::deque<Slave> slaves;
    unsigned full_width = 4, ids = 0;
    std::optional<BridgeBurst> comes, waits;  // the next one; not posted, under way
    std::array<Memory, 2> expected{Memory(REGION + 16), Memory(REGION + 16)};
    std::map<Refusal, unsigned> refusals;
};

constexpr std::uint64_t BEATS = 200'000;  // of each bridge: more than a million of all

TEST_F(HpsBridges, Of32Bits) { play(4, BEATS); }
TEST_F(HpsBridges, Of64Bits) { play(8, BEATS); }
TEST_F(HpsBridges, Of128Bits) { play(16, BEATS); }

}  // namespace
