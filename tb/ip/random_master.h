// random_master.h - a master of AXI3 (ARM IHI 0022D) or of Avalon-MM with random bursts, which
// knows what it must read
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <random>
#include <vector>

namespace sim::test {

constexpr unsigned REGION = 4096;  // of each port, whose master is alone there
constexpr unsigned BRIDGE = 6;     // the port that may answer that nobody is there
constexpr unsigned NOBODY = 1u << 20;

struct Burst {
    bool write;
    std::uint32_t address;
    unsigned beats, size, kind;  // size: a logarithm; kind: AXI's ARBURST
    std::uint8_t id;
    bool is_refused = false;

    std::uint32_t address_of(unsigned beat) const {
        const std::uint32_t bytes = 1u << size, aligned = address & ~(bytes - 1);
        if (beat == 0 || kind == 0) return address;
        const std::uint32_t next = aligned + beat * bytes, whole = beats * bytes;
        return kind == 1 ? next : address / whole * whole + next % whole;
    }
};

struct Beat {
    std::array<std::uint8_t, 32> data{};
    std::uint32_t strobes = 0;
};

// What a master sees and drives of its port, in the bench's ports.
struct Wires {
    std::function<void(const Burst*)> command;  // null: not valid
    std::function<bool(bool write)> command_ready;
    std::function<void(const Beat*, bool last)> data;  // null: not valid
    std::function<bool()> data_ready;
    std::function<void(bool)> take_reads, take_responses;
    struct Read {
        Beat beat;
        unsigned id, response;
        bool last;
        bool operator==(const Read& o) const {
            return beat.data == o.beat.data && id == o.id && response == o.response &&
                   last == o.last;
        }
    };
    std::function<std::optional<Read>()> read;
    struct Response {
        unsigned id, response;
        bool operator==(const Response& o) const { return id == o.id && response == o.response; }
    };
    std::function<std::optional<Response>()> response;
};

// A master that is alone in its region.  AXI: writes until their responses, then reads; Avalon-MM:
// mixed, in order.
class Master {
public:
    Master(Wires wires, unsigned port, unsigned width, bool is_axi, bool reads, bool writes,
           std::mt19937& random, const std::vector<std::uint8_t>& memory)
        : wires_{std::move(wires)},
          base_{port * REGION},
          width_{width},
          size_{width == 4    ? 2u
                : width == 8  ? 3u
                : width == 16 ? 4u
                              : 5u},
          is_axi_{is_axi},
          reads_{reads},
          writes_{writes},
          random_{random},
          expected_(REGION) {
        std::copy_n(memory.begin() + base_, REGION, expected_.begin());
    }

    std::uint64_t beats() const { return beats_; }

    // Before the clock's edge.
    void drive() {
        if (!command_ && random_() % 3) command_ = next();
        wires_.command(command_ ? &*command_ : nullptr);
        const bool goes_with_it = !is_axi_ && command_ && command_->write;
        if (!word_ && (goes_with_it || (!to_write_.empty() && random_() % 3))) word_ = new_word();
        wires_.data(word_ ? &*word_ : nullptr, word_ && is_last());
        takes_reads_ = !is_axi_ || random_() % 3;
        takes_responses_ = random_() % 3;
        wires_.take_reads(takes_reads_);
        wires_.take_responses(takes_responses_);
    }

    // What the edge has done, as the ports were before it.
    void look() {
        const bool command_taken = command_ && wires_.command_ready(command_->write);
        if (word_ && (is_axi_ ? wires_.data_ready() : command_taken)) {
            write(*word_);
            word_.reset();
        }
        if (command_taken && (is_axi_ || !command_->write || avalon_done_)) {
            if (is_axi_ && command_->write) to_write_.push_back(*command_);
            if (!command_->write) to_read_.push_back({*command_, 0, expected_});
            command_.reset();
            avalon_done_ = false;
        }
        look_at_reads();
        look_at_responses();
    }

private:
    struct Reading {
        Burst burst;
        unsigned beat;
        std::vector<std::uint8_t> expected;  // the region, as the read's command was taken
    };

    std::optional<Burst> next() {
        Burst burst{};
        if (is_axi_) {
            const bool idle = to_read_.empty() && to_write_.empty() && answers_.empty();
            if (idle) writing_ = writes_ && (!reads_ || random_() % 2), left_ = 1 + random_() % 10;
            if (left_ == 0) return {};
            --left_;
            burst.write = writing_;
            burst.size = random_() % (size_ + 1);
            burst.kind = random_() % 3;
            burst.beats = burst.kind == 2 ? 2u << random_() % 4 : 1 + random_() % 16;
            burst.address = base_ + random_() % (REGION - 16 * 32);
            if (burst.kind == 2) burst.address &= ~((1u << burst.size) - 1);
            burst.id = static_cast<std::uint8_t>(random_());
            burst.is_refused = random_() % 50 == 0 && is_bridge();
            if (burst.is_refused) burst.address += NOBODY;
        } else {
            burst.write = writes_ && (!reads_ || random_() % 2);
            burst.size = size_;
            burst.kind = 1;
            burst.beats = 1 + random_() % (random_() % 4 ? 8 : 64);
            burst.address = base_ + random_() % ((REGION - 64 * width_) / width_) * width_;
        }
        return burst;
    }
    bool is_bridge() const { return base_ == BRIDGE * REGION; }

    Burst& writing() { return is_axi_ ? to_write_.front() : *command_; }
    bool is_last() { return beat_ + 1 == writing().beats; }

    Beat new_word() {
        Beat beat;
        const Burst& burst = writing();
        const std::uint32_t address = burst.address_of(beat_), bytes = 1u << burst.size;
        for (std::uint8_t& byte : beat.data) byte = static_cast<std::uint8_t>(random_());
        for (std::uint32_t a = address; a < (address & ~(bytes - 1)) + bytes; ++a)
            if (burst.is_refused || random_() % 4) beat.strobes |= 1u << a % width_;
        return beat;
    }

    void write(const Beat& beat) {
        const Burst burst = writing();
        const std::uint32_t base = burst.address_of(beat_) / width_ * width_;
        for (unsigned n = 0; n < width_ && !burst.is_refused; ++n)
            if (beat.strobes >> n & 1) expected_[base + n - base_] = beat.data[n];
        ++beats_;
        if (++beat_ < burst.beats) return;
        beat_ = 0;
        avalon_done_ = true;
        if (!is_axi_) return;
        answers_.push_back(burst);
        to_write_.pop_front();
    }

    void look_at_reads() {
        const std::optional<Wires::Read> read = wires_.read();
        if (waiting_read_) {
            EXPECT_EQ(read, waiting_read_) << "R is not held until it is taken";
        }
        waiting_read_.reset();
        if (!read) return;
        if (!takes_reads_) {
            waiting_read_ = read;
            return;
        }
        ASSERT_FALSE(to_read_.empty()) << "a word that nobody has asked for";
        Reading& reading = to_read_.front();
        const Burst& burst = reading.burst;
        const std::uint32_t address = burst.address_of(reading.beat), bytes = 1u << burst.size;
        for (std::uint32_t a = address; a < (address & ~(bytes - 1)) + bytes && !burst.is_refused;
             ++a)
            ASSERT_EQ(read->beat.data[a % width_], reading.expected[a - base_])
                << "at " << a << " of a burst of " << burst.beats;
        const bool last = ++reading.beat == burst.beats;
        if (is_axi_) {
            EXPECT_EQ(read->id, burst.id);
            EXPECT_EQ(read->last, last);
            EXPECT_EQ(read->response, burst.is_refused ? 3u : 0u);
        }
        ++beats_;
        if (last) to_read_.pop_front();
    }

    void look_at_responses() {
        if (!is_axi_) return;
        const std::optional<Wires::Response> response = wires_.response();
        if (waiting_response_) {
            EXPECT_EQ(response, waiting_response_) << "B is not held until it is taken";
        }
        waiting_response_.reset();
        if (!response) return;
        if (!takes_responses_) {
            waiting_response_ = response;
            return;
        }
        ASSERT_FALSE(answers_.empty()) << "a response to nothing";
        EXPECT_EQ(response->id, answers_.front().id);
        EXPECT_EQ(response->response == 3, answers_.front().is_refused);
        answers_.pop_front();
    }

    Wires wires_;
    const std::uint32_t base_;
    const unsigned width_, size_;  // of the bus: bytes, their logarithm
    const bool is_axi_, reads_, writes_;
    std::mt19937& random_;
    std::vector<std::uint8_t> expected_;

    std::optional<Burst> command_;
    std::optional<Beat> word_;
    std::deque<Burst> to_write_, answers_;
    std::deque<Reading> to_read_;
    unsigned beat_ = 0, left_ = 0;
    bool writing_ = false, avalon_done_ = false;
    bool takes_reads_ = false, takes_responses_ = false;
    std::optional<Wires::Read> waiting_read_;
    std::optional<Wires::Response> waiting_response_;
    std::uint64_t beats_ = 0;
};

}  // namespace sim::test
