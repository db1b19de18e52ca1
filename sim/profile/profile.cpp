#include "sim/profile/profile.h"

#include <algorithm>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr std::size_t DEEPEST = 100'000;  // calls; a program that never returns from one has more

}  // namespace

Profile::Profile(const ArmCore& core, const ElfProgram& elf)
    : core_{core}, elf_{elf}, own_(elf.functions.size() + 1), function_{elf.functions.size()} {}

bool Profile::before(std::uint32_t pc) {
    if (pc - begin_ >= end_ - begin_ || begin_ > end_) change(pc);
    ++own_[function_];
    ++count_;
    last_pc_ = pc;
    return false;
}

void Profile::locate(std::uint32_t pc) {
    const auto& all = elf_.functions;
    const auto next = std::upper_bound(
        all.begin(), all.end(), pc,
        [](std::uint32_t value, const ElfFunction& f) { return value < f.address; });
    const std::uint32_t border = next == all.end() ? 0xFFFFFFFF : next->address;
    function_ = all.size();
    begin_ = pc;
    end_ = pc + 1;
    if (next == all.begin()) return;
    const ElfFunction& f = *(next - 1);
    const std::uint32_t end = f.size == 0 ? border : std::min(border, f.address + f.size);
    if (pc >= end) return;
    function_ = static_cast<std::size_t>(next - 1 - all.begin());
    begin_ = f.address;
    end_ = end;
}

void Profile::change(std::uint32_t pc) {
    const std::size_t before = function_;
    locate(pc);
    const auto back = std::find_if(calls_.rbegin(), calls_.rend(),
                                   [pc](const Call& call) { return call.return_to == pc; });
    if (back != calls_.rend()) {
        const auto left = static_cast<std::size_t>(back - calls_.rbegin()) + 1;
        for (std::size_t i = 0; i < left; ++i) {
            leave(edges_, calls_.back());
            calls_.pop_back();
        }
        return;
    }
    const std::uint32_t link = core_.reg(14) & ~1u;
    const bool called = link == last_pc_ + 4 || link == last_pc_ + 2;
    if (called && function_ != before && calls_.size() < DEEPEST)
        calls_.push_back({before, function_, link, count_});
}

void Profile::leave(Edges& edges, const Call& call) const {
    Edge& edge = edges[{call.caller, call.callee}];
    ++edge.calls;
    edge.instructions += count_ - call.begin;
}

std::string Profile::name(std::size_t function) const {
    if (function == elf_.functions.size()) return "???";
    return elf_.function(elf_.functions[function].address);
}

std::string Profile::callgrind() const {
    Edges edges = edges_;
    for (auto call = calls_.rbegin(); call != calls_.rend(); ++call) leave(edges, *call);
    const std::string file = elf_.file.string();
    std::string text = fmt::format(
        "# callgrind format\nversion: 1\ncreator: de1sim\ncmd: {}\npositions: line\n"
        "events: Instructions\nsummary: {}\n\nob={}\n",
        file, count_, file);
    for (std::size_t f = 0; f < own_.size(); ++f) {
        auto edge = edges.lower_bound({f, 0});
        const bool calls = edge != edges.end() && edge->first.first == f;
        if (own_[f] == 0 && !calls) continue;
        text += fmt::format("\nfl=???\nfn=({}) {}\n0 {}\n", f + 1, name(f), own_[f]);
        for (; edge != edges.end() && edge->first.first == f; ++edge)
            text += fmt::format("cfn=({}) {}\ncalls={} 0\n0 {}\n", edge->first.second + 1,
                                name(edge->first.second), edge->second.calls,
                                edge->second.instructions);
    }
    return text;
}

}  // namespace sim
