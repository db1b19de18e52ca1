#include "sim/profile/profile.h"

#include <algorithm>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr std::size_t DEEPEST = 100'000;  // calls; only a program that does not return has more

}  // namespace

Profile::Profile(const ElfProgram& elf)
    : elf_{elf}, own_(elf.functions.size() + 1), here_{elf.functions.size(), 0, 0} {}

void Profile::ran(const Run& run) {
    if (run.begin - here_.begin >= here_.end - here_.begin) change(run.begin, run.link);
    own_[here_.function] += run.instructions;
    count_ += run.instructions;
    last_end_ = run.end;
}

Profile::Place Profile::place_of(std::uint32_t pc) const {
    const auto& all = elf_.functions;
    const auto next = std::upper_bound(
        all.begin(), all.end(), pc,
        [](std::uint32_t value, const ElfFunction& f) { return value < f.address; });
    if (next == all.begin()) return place_outside(pc);
    const ElfFunction& f = *(next - 1);
    std::uint32_t border = next == all.end() ? 0xFFFFFFFF : next->address;
    for (const ElfSegment& segment : elf_.segments)
        if (f.address - segment.address < segment.size)
            border = std::min(border, segment.address + segment.size);
    const std::uint32_t end = f.size == 0 ? border : std::min(border, f.address + f.size);
    if (pc >= end) return place_outside(pc);
    return {static_cast<std::size_t>(next - 1 - all.begin()), f.address, end};
}

Profile::Place Profile::place_outside(std::uint32_t pc) const {
    const std::size_t nowhere = elf_.functions.size();
    for (std::size_t i = elf_.libraries.size(); i-- > 0;)
        for (const ElfSegment& segment : elf_.libraries[i].segments)
            if (pc - segment.address < segment.size)
                return {nowhere + 1 + i, segment.address, segment.address + segment.size};
    return {nowhere, pc, pc + 1};
}

bool Profile::same_function(std::uint32_t pc, std::uint32_t other) const {
    return place_of(pc).function == place_of(other).function;
}

void Profile::change(std::uint32_t pc, std::uint32_t link) {
    const std::size_t before = here_.function;
    here_ = place_of(pc);
    if (here_.function >= own_.size()) own_.resize(here_.function + 1);
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
    const bool called = (link & ~1u) == last_end_;
    if (called && here_.function != before && calls_.size() < DEEPEST) {
        calls_.push_back({before, here_.function, last_end_, count_});
        on_call(calls_.size(), before, here_.function);
    }
}

void Profile::leave(Edges& edges, const Call& call) const {
    Edge& edge = edges[{call.caller, call.callee}];
    ++edge.calls;
    edge.instructions += count_ - call.begin;
}

std::string Profile::name(std::size_t function) const {
    const std::size_t nowhere = elf_.functions.size();
    if (function == nowhere) return "???";
    if (function > nowhere) return elf_.libraries[function - nowhere - 1].file.filename().string();
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
