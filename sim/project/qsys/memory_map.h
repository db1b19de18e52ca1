// memory_map.h - the masters and slaves of a system, and who reaches whom at which address
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/project/qsys/assembly.h"

namespace sim::project::qsys {

struct Master {
    End end;
    unsigned width;
    std::string clock;  // its root
    bool is_bridge;     // of the processor
};

struct Slave {
    End end;
    unsigned width, address_bits, shift;
    std::uint64_t span;
    bool reads, writes;
    std::string clock;  // its root
};

// A connection, by the numbers of its ends.
struct Link {
    std::size_t master, slave;
    std::uint64_t base;  // of the slave, in the master's addresses
    unsigned shares;     // of the arbiter's turns
};

// What a master reaches.
struct Place {
    std::string master;  // "hps_0.h2f_lw_axi_master"
    std::string slave;   // "led.s1"
    std::uint64_t base, span;
    bool reads, writes;
    std::uint32_t window;  // of the processor's bridge, in its addresses; 0 for other masters
};

bool is_axi(const Interface& slave);  // AXI3, AXI4 or AXI4-Lite

// Of an Avalon interface: whether a property is set; whether it counts a burst's bytes, not its
// words; the words of its longest burst, a power of 2, with data of `width` bits.
bool is_set(const Interface& interface, const char* property);
bool in_symbols(const Interface& interface);
unsigned longest_burst(const Interface& interface, unsigned width);

// Of a bridge of the processor, in its addresses; 0 for other masters.
std::uint32_t window_of(const Master& master);

class MemoryMap {
public:
    // ProjectError: a slave whose base is not a multiple of its span, two at one address, a width
    // that Avalon has not, a kind that is not simulated.
    explicit MemoryMap(const Assembly& assembly);

    const std::vector<Master>& masters() const { return masters_; }
    const std::vector<Slave>& slaves() const { return slaves_; }
    std::vector<Link> links_of(std::size_t master) const;  // by address
    // Which of the links an address of nobody goes to: the largest slave that takes such an access,
    // of equals the lowest.
    std::size_t default_of(const std::vector<Link>& links, bool write) const;

    // What each master reaches, also through bridges.
    const std::vector<Place>& places() const { return places_; }
    const std::vector<std::string>& notes() const { return notes_; }

private:
    Master master(const End& e) const;
    Slave slave(const End& e) const;
    void check_addresses(std::size_t master) const;
    void add_places(const Master& master, const std::vector<Link>& links, std::uint64_t base,
                    std::uint64_t end, unsigned depth);

    const Assembly& assembly_;
    std::vector<Master> masters_;
    std::vector<Slave> slaves_;
    std::vector<Link> links_;
    std::vector<Place> places_;
    std::vector<std::string> notes_;
};

}  // namespace sim::project::qsys
