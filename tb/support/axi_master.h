// axi_master.h - drives one AXI3 port of a Verilated module, clock by clock, with random pauses.
//
// Every channel is a queue of its own, so requests, data and responses overlap as in a real master.
// `stall` is the chance in percent that a channel pauses in a clock: VALID stays low (never once it
// was high), READY stays low.
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

namespace tb {

struct WriteRequest {
    std::uint16_t id;
    std::uint32_t addr;
    std::uint8_t size, burst;
    std::vector<std::uint32_t> data;
    std::vector<std::uint8_t> strobes;
};
struct ReadRequest {
    std::uint16_t id;
    std::uint32_t addr;
    std::uint8_t beats, size, burst;
};
struct WriteResponse {
    std::uint16_t id;
    std::uint8_t resp;
};
struct ReadBeat {
    std::uint16_t id;
    std::uint32_t data;
    std::uint8_t resp;
    bool last;
};

constexpr std::uint8_t FIXED = 0, INCR = 1, WRAP = 2;
constexpr std::uint8_t OKAY = 0, SLVERR = 2, DECERR = 3;

// Dut has the port's signals under the plain names awid_i ... rready_i.
template <class Dut>
class AxiMaster {
public:
    explicit AxiMaster(Dut& dut) : dut_{dut} {}

    unsigned stall = 0;
    bool hold_data = false;  // no write data while set
    std::vector<WriteResponse> written;
    std::vector<ReadBeat> beats;

    void write(const WriteRequest& r) {
        aw_.push_back(r);
        for (std::size_t i = 0; i < r.data.size(); ++i)
            w_.push_back({r.data[i], r.strobes[i], i + 1 == r.data.size()});
        ++writes_open_;
    }
    void read(const ReadRequest& r) {
        ar_.push_back(r);
        beats_open_ += r.beats;
    }
    bool idle() const {
        return written.size() == writes_open_ && beats.size() == beats_open_ && aw_.empty();
    }

    // Drops the responses so far.
    void forget() {
        written.clear();
        beats.clear();
        writes_open_ = beats_open_ = 0;
    }

    // Before the rising edge: what the slave will see.  After it: what was taken.
    void before_edge() {
        if (!dut_.awvalid_i && !aw_.empty() && go()) {
            const WriteRequest& r = aw_.front();
            dut_.awid_i = r.id;
            dut_.awaddr_i = r.addr;
            dut_.awlen_i = static_cast<std::uint8_t>(r.data.size() - 1);
            dut_.awsize_i = r.size;
            dut_.awburst_i = r.burst;
            dut_.awvalid_i = 1;
        }
        if (!dut_.wvalid_i && !w_.empty() && !hold_data && go()) {
            dut_.wdata_i = w_.front().data;
            dut_.wstrb_i = w_.front().strobes;
            dut_.wvalid_i = 1;
        }
        if (!dut_.arvalid_i && !ar_.empty() && go()) {
            const ReadRequest& r = ar_.front();
            dut_.arid_i = r.id;
            dut_.araddr_i = r.addr;
            dut_.arlen_i = static_cast<std::uint8_t>(r.beats - 1);
            dut_.arsize_i = r.size;
            dut_.arburst_i = r.burst;
            dut_.arvalid_i = 1;
        }
        dut_.bready_i = go();
        dut_.rready_i = go();
        dut_.eval();
        aw_taken_ = dut_.awvalid_i && dut_.awready_o;
        w_taken_ = dut_.wvalid_i && dut_.wready_o;
        ar_taken_ = dut_.arvalid_i && dut_.arready_o;
        if (dut_.bvalid_o && dut_.bready_i) written.push_back({dut_.bid_o, dut_.bresp_o});
        if (dut_.rvalid_o && dut_.rready_i)
            beats.push_back({dut_.rid_o, dut_.rdata_o, dut_.rresp_o, dut_.rlast_o != 0});
    }
    void after_edge() {
        if (aw_taken_) aw_.pop_front(), dut_.awvalid_i = 0;
        if (w_taken_) w_.pop_front(), dut_.wvalid_i = 0;
        if (ar_taken_) ar_.pop_front(), dut_.arvalid_i = 0;
    }

private:
    struct Beat {
        std::uint32_t data;
        std::uint8_t strobes;
        bool last;
    };
    bool go() { return random_() % 100 >= stall; }

    Dut& dut_;
    std::mt19937 random_{1};
    std::deque<WriteRequest> aw_;
    std::deque<Beat> w_;
    std::deque<ReadRequest> ar_;
    bool aw_taken_ = false, w_taken_ = false, ar_taken_ = false;
    std::size_t writes_open_ = 0, beats_open_ = 0;
};

}  // namespace tb
