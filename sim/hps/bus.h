// bus.h - the processor's address map: decodes, forwards, counts, and answers every wrong access.
//
// Loosely timed: adds no delay of its own; the target's delay is the access's.
// An address that no window owns, or an access that leaves its window, is TLM_ADDRESS_ERROR; so is
// one to a window that is switched off, as a bridge in reset is.
//
// refusal() says in words why an access was refused.  For that, describe() names the places within
// a window that does not answer everywhere.
//
// Requests for direct access (DMI) are passed to the window's target; they are invalidated when the
// window is switched.  If it is refused, the range that is returned has no direct access: a window,
// or the gap between two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/hps/axi_attributes.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

struct BusCounts {
    std::uint64_t reads = 0, writes = 0;  // transactions of up to a word
    std::uint64_t bursts = 0;             // longer ones
    std::uint64_t errors = 0;             // answered with anything but OK
};

class Bus : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Bus> socket;

    explicit Bus(const sc_core::sc_module_name& name);

    // Adds a window and returns the socket that serves it, with addresses from 0.  Two windows that
    // overlap are a fault in the assembly: SC_REPORT_FATAL.
    tlm_utils::simple_initiator_socket<Bus>& window(const std::string& name, std::uint32_t base,
                                                    std::uint32_t size);

    // The switch of the window `name`: true is on, as all are at first.  A name that no window has
    // is a fault in the assembly: SC_REPORT_FATAL.
    std::function<void(bool)> gate(const std::string& name);

    // A block of registers, or memory.
    struct Place {
        std::string name;
        std::uint32_t base, size;
        bool is_memory = false;
    };
    // The places within the window `name`; `title` is its name in messages.  As gate().
    void describe(const std::string& name, std::string title, std::vector<Place> places);
    // Addresses of a window that its interconnect answers at other ones: `size` bytes from `from`
    // on, and the same again each `each` bytes, at `to`.  A burst that begins before them is not
    // cut.
    struct Detour {
        std::uint32_t from, size, each, to;
    };
    // Of the window `name`; as gate().
    void divert(const std::string& name, const Detour& detour);
    bool is_diverted(std::uint32_t address) const;
    // Places of the board that have no window.
    void leave_out(std::vector<Place> places) { absent_ = std::move(places); }

    // "no memory at 0xC4000000: SDRAM ends at 0xC3FFFFFF", "no block at 0xFF2FF000: the nearest is
    // LEDR, 0xFF200000 to 0xFF20000F".  `bytes` 0: an instruction fetch.
    std::string refusal(std::uint32_t address, unsigned bytes, bool write,
                        tlm::tlm_response_status answer) const;

    // `notify` is called after each access to the window `name` that was answered OK; as gate().
    using Notify = std::function<void(std::uint32_t address, unsigned bytes, bool write)>;
    void on_answered(const std::string& name, Notify notify);

    struct Access {
        sc_core::sc_time begin, end;  // of the initiator's own time
        std::uint32_t address;
        unsigned bytes;
        bool write, answered;  // with OK
        const unsigned char* data;
    };
    // `watch` is called after each access, whatever its answer.  Direct access passes it by.
    void on_access(std::function<void(const Access&)> watch) { watch_ = std::move(watch); }
    bool is_watched() const { return static_cast<bool>(watch_); }
    // Counts accesses that an initiator has left out because it knows the answers.
    void left_out(bool write, std::uint64_t accesses) {
        (write ? counts_.writes : counts_.reads) += accesses;
    }
    // The place at `address`: "LEDR", or "" where there is none.
    std::string place(std::uint32_t address) const;
    bool has_place(std::uint32_t address) const;
    // Registers of 32 bits, by address.
    void name_registers(std::map<std::uint32_t, std::string> names) {
        registers_ = std::move(names);
    }
    // The register at `address`, "KEY_EDGE"; else as place().
    std::string register_at(std::uint32_t address) const;

    // An access of another master than the processor, with its delay; false: refused.
    bool transfer(bool write, std::uint32_t address, unsigned char* data, unsigned bytes,
                  sc_core::sc_time& delay) {
        return forward(write, address, data, bytes, nullptr, delay);
    }
    // A burst of one, of `bytes` together.
    bool transfer(bool write, std::uint32_t address, unsigned char* data, unsigned bytes,
                  AxiAttributes& how, sc_core::sc_time& delay);
    // To the window `name` it comes as one transaction, to others as one for each beat; as gate().
    void show_bursts(const std::string& name) { windows_[number_of(name)].shows_bursts = true; }

    const BusCounts& counts() const { return counts_; }
    // Something was written through the window `name`; as gate().
    bool written(const std::string& name) const { return windows_[number_of(name)].written; }

private:
    struct Window {
        std::string name;
        std::uint32_t base, size;
        std::unique_ptr<tlm_utils::simple_initiator_socket<Bus>> socket;
        bool on = true, written = false, shows_bursts = false;
        std::string title = name;
        std::vector<Place> places = {{name, base, size}};
        Notify notify = {};  // may be none
        std::optional<Detour> detour = {};

        // Of an address on the bus, that behind the window.
        std::uint32_t within(std::uint32_t address) const;
    };

    void b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool get_direct_mem_ptr(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    bool forward(bool write, std::uint32_t address, unsigned char* data, unsigned bytes,
                 AxiAttributes* how, sc_core::sc_time& delay);
    Window* find(std::uint64_t address, unsigned bytes);
    std::size_t number_of(const std::string& name) const;

    std::vector<Window> windows_;
    std::vector<Place> absent_;
    std::map<std::uint32_t, std::string> registers_;
    BusCounts counts_;
    std::function<void(const Access&)> watch_;
};

}  // namespace sim
