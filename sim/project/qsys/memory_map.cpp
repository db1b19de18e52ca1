#include "sim/project/qsys/memory_map.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "sim/hps/bridge_windows.h"
#include "sim/text/lower.h"

namespace sim::project::qsys {

namespace {

constexpr const char* FULL_MASTER = "h2f_axi_master";
constexpr unsigned WIDEST = 1024, NATIVE = 32;  // bits of data
constexpr unsigned DEEPEST = 20;                // bridges one after another

}  // namespace

bool is_axi(const Interface& slave) {
    return slave.type == "axi" || slave.type == "axi4" || slave.type == "axi4lite";
}

bool is_set(const Interface& interface, const char* property) {
    const std::string value = lower(interface.property(property));
    return value == "true" || value == "1";
}

bool in_symbols(const Interface& interface) {
    return lower(interface.property("burstcountUnits", "WORDS")) == "symbols";
}

unsigned longest_burst(const Interface& interface, unsigned width) {
    constexpr unsigned MOST = 1024;  // words, by Avalon
    const Port* count = interface.port("burstcount");
    if (!count || count->width == 0) return 1;
    std::uint64_t words = std::uint64_t{1} << (std::min(count->width, NATIVE) - 1);
    if (in_symbols(interface)) words = words * 8 / width;
    return static_cast<unsigned>(std::clamp<std::uint64_t>(words, 1, MOST));
}

MemoryMap::MemoryMap(const Assembly& assembly) : assembly_{assembly} {
    std::map<std::string, std::size_t> masters, slaves;
    for (const Connection& c : assembly_.connections()) {
        if (c.kind != Connection::Kind::AVALON) continue;
        const End m = assembly_.end(c.start), s = assembly_.end(c.end);
        if (!masters.count(c.start)) {
            masters[c.start] = masters_.size();
            masters_.push_back(master(m));
        }
        if (!slaves.count(c.end)) {
            slaves[c.end] = slaves_.size();
            slaves_.push_back(slave(s));
        }
        links_.push_back({masters[c.start], slaves[c.end], c.base, c.shares});
    }
    for (std::size_t n = 0; n < masters_.size(); ++n) check_addresses(n);
    for (std::size_t n = 0; n < masters_.size(); ++n)
        add_places(masters_[n], links_of(n), 0, std::uint64_t{1} << 32, 0);
}

Master MemoryMap::master(const End& e) const {
    const Assembly::Clock clock = assembly_.clock_of(e);
    if (e.is_processors()) {
        return {e, e.interface->number("dataWidth", 32), clock.root, true};
    }
    const bool axi = is_axi(*e.interface);
    if (!axi && e.interface->type != "avalon")
        assembly_.fail(
            fmt::format("the master {} is of type {}, which is not simulated: "
                        "expected avalon, axi, axi4 or axi4lite",
                        e.name(), e.interface->type));
    const Port* data = e.interface->port(axi ? "rdata" : "readdata");
    if (!data) data = e.interface->port(axi ? "wdata" : "writedata");
    const Port* address = e.interface->port(axi ? "araddr" : "address");
    if (!address && axi) address = e.interface->port("awaddr");
    if (!data || !address)
        assembly_.fail(fmt::format("the master {} has no address, or no data", e.name()));
    return {e, data->width, clock.root, false};
}

Slave MemoryMap::slave(const End& e) const {
    const bool axi = is_axi(*e.interface);
    if (!axi && e.interface->type != "avalon")
        assembly_.fail(
            fmt::format("the slave {} is of type {}, which is not simulated: "
                        "expected avalon, apb, axi, axi4 or axi4lite",
                        e.name(), e.interface->type));
    const Port* read = e.interface->port(axi ? "rdata" : "readdata");
    const Port* write = e.interface->port(axi ? "wdata" : "writedata");
    const Port* address = e.interface->port(!axi ? "address" : write ? "awaddr" : "araddr");
    if (!read && !write) assembly_.fail(fmt::format("the slave {} has no data", e.name()));
    Slave s{e,
            (read ? read : write)->width,
            address ? address->width : 0,
            0,
            0,
            read != nullptr,
            write != nullptr,
            assembly_.clock_of(e).root};
    // Each word of a slave that is aligned so has a word of 32 bits of its own.
    if (lower(e.interface->property("addressAlignment")) == "native")
        s.width = std::max(s.width, NATIVE);
    const std::uint64_t bytes = s.width / 8;
    if (s.width % 8 || (s.width & (s.width - 1)) || s.width > WIDEST)
        assembly_.fail(fmt::format("the slave {} has {} bits of data, expected 8, 16, ... 1024",
                                   e.name(), s.width));
    if (!axi && lower(e.interface->property("addressUnits", "WORDS")) != "symbols")
        while (1u << s.shift < bytes) ++s.shift;
    s.span = e.interface->number("explicitAddressSpan", 0);
    if (s.span == 0) s.span = (std::uint64_t{1} << s.address_bits) << s.shift;
    std::uint64_t whole = bytes;
    while (whole < s.span) whole *= 2;
    s.span = whole;
    return s;
}

std::vector<Link> MemoryMap::links_of(std::size_t master) const {
    std::vector<Link> all;
    for (const Link& link : links_)
        if (link.master == master) all.push_back(link);
    std::sort(all.begin(), all.end(), [](const Link& a, const Link& b) { return a.base < b.base; });
    return all;
}

void MemoryMap::check_addresses(std::size_t master) const {
    const std::vector<Link> all = links_of(master);
    for (std::size_t n = 0; n < all.size(); ++n) {
        const Slave& s = slaves_[all[n].slave];
        if (all[n].base % s.span)
            assembly_.fail(fmt::format("{} is at 0x{:x}, which is no multiple of its {} bytes",
                                       s.end.name(), all[n].base, s.span));
        if (n && all[n - 1].base + slaves_[all[n - 1].slave].span > all[n].base)
            assembly_.fail(fmt::format("{} and {} have the same addresses of {}, from 0x{:x} on",
                                       slaves_[all[n - 1].slave].end.name(), s.end.name(),
                                       masters_[master].end.name(), all[n].base));
    }
}

// From `base` on, up to `end`.
void MemoryMap::add_places(const Master& master, const std::vector<Link>& links, std::uint64_t base,
                           std::uint64_t end, unsigned depth) {
    for (const Link& link : links) {
        const Slave& s = slaves_[link.slave];
        const std::uint64_t first = base + link.base;
        if (first >= end) continue;
        const std::string through = s.end.interface->property("bridgesToMaster");
        const std::string after = s.end.instance->name + "." + through;
        const auto next = std::find_if(masters_.begin(), masters_.end(),
                                       [&](const Master& m) { return m.end.name() == after; });
        if (through.empty() || next == masters_.end() || depth == DEEPEST)
            places_.push_back({master.end.name(), s.end.name(), first, s.span, s.reads, s.writes,
                               window_of(master)});
        else
            add_places(master, links_of(static_cast<std::size_t>(next - masters_.begin())), first,
                       std::min(end, first + s.span), depth + 1);
    }
}

std::uint32_t window_of(const Master& master) {
    if (!master.is_bridge) return 0;
    return master.end.interface->name == FULL_MASTER ? H2F_BASE : LW_BASE;
}

std::size_t MemoryMap::default_of(const std::vector<Link>& links, bool write) const {
    std::size_t best = links.size(), largest = 0;
    for (std::size_t n = 0; n < links.size(); ++n) {
        const Slave& s = slaves_[links[n].slave];
        if (s.span > slaves_[links[largest].slave].span) largest = n;
        if (!(write ? s.writes : s.reads)) continue;
        if (best == links.size() || s.span > slaves_[links[best].slave].span) best = n;
    }
    return best == links.size() ? largest : best;  // who then must answer
}

}  // namespace sim::project::qsys
