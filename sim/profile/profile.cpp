#include "sim/profile/profile.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr std::size_t DEEPEST = 100'000;  // calls; only a program that does not return has more

// The number of the object's function there, or one more.  No value: it is not the object's.
std::optional<Profile::Place> place_in(const ElfProgram& object, std::uint32_t pc) {
    const auto segment =
        std::find_if(object.segments.begin(), object.segments.end(),
                     [pc](const ElfSegment& s) { return pc - s.address < s.size; });
    if (segment == object.segments.end()) return std::nullopt;
    std::uint32_t begin = segment->address, end = segment->address + segment->size;
    const auto& all = object.functions;
    const auto next = std::upper_bound(
        all.begin(), all.end(), pc,
        [](std::uint32_t value, const ElfFunction& f) { return value < f.address; });
    if (next != all.end()) end = std::min(end, next->address);
    if (next != all.begin() && std::prev(next)->address >= begin) {
        const ElfFunction& f = *std::prev(next);
        const std::uint32_t f_end = f.size == 0 ? end : std::min(end, f.address + f.size);
        if (pc < f_end)
            return Profile::Place{static_cast<std::size_t>(std::prev(next) - all.begin()),
                                  f.address, f_end};
        begin = f_end;
    }
    return Profile::Place{all.size(), begin, end};
}

}  // namespace

Profile::Profile(const ElfProgram& elf)
    : elf_{elf}, own_(elf.functions.size() + 1), here_{elf.functions.size(), 0, 0} {}

void Profile::ran(const Run& run) {
    if (!is_here(run.begin)) change(run.begin, run.link);
    own_[here_.function] += run.instructions;
    count_ += run.instructions;
    last_end_ = run.end;
}

// ---- Functions by number: those of the program and "???", those of each library and itself ------

const ElfProgram& Profile::object(std::size_t i) const {
    return i == 0 ? elf_ : elf_.libraries[i - 1];
}

// What has been loaded last may lie where something else was.
Profile::Place Profile::place_of(std::uint32_t pc) const {
    std::size_t first = elf_.functions.size() + 1;
    for (const ElfProgram& library : elf_.libraries) first += library.functions.size() + 1;
    for (std::size_t i = elf_.libraries.size() + 1; i-- > 0;) {
        first -= object(i).functions.size() + 1;
        if (auto place = place_in(object(i), pc)) {
            place->function += first;
            return *place;
        }
    }
    return {elf_.functions.size(), pc, pc + 1};
}

std::size_t Profile::object_of(std::size_t& function) const {
    std::size_t i = 0;
    for (; function > object(i).functions.size(); ++i) function -= object(i).functions.size() + 1;
    return i;
}

std::string Profile::name_in(std::size_t i, std::size_t function) const {
    const auto& all = object(i).functions;
    if (function < all.size()) return object(i).function(all[function].address);
    return i == 0 ? "???" : object(i).file.filename().string();
}

// Tools add up what has the same name in the same source file.
std::string Profile::source_of(std::size_t i) const {
    return i == 0 ? "???" : object(i).file.filename().string();
}

std::string Profile::name(std::size_t function) const {
    const std::size_t i = object_of(function);
    const std::string name = name_in(i, function);
    if (i == 0 || function == object(i).functions.size()) return name;
    return name + " of " + object(i).file.filename().string();
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

std::string Profile::callgrind() const {
    Edges edges = edges_;
    for (auto call = calls_.rbegin(); call != calls_.rend(); ++call) leave(edges, *call);
    std::string text = fmt::format(
        "# callgrind format\nversion: 1\ncreator: de1sim\ncmd: {}\npositions: line\n"
        "events: Instructions\nsummary: {}\n",
        elf_.file.string(), count_);
    for (std::size_t f = 0; f < own_.size(); ++f) {
        auto edge = edges.lower_bound({f, 0});
        const bool calls = edge != edges.end() && edge->first.first == f;
        if (own_[f] == 0 && !calls) continue;
        std::size_t function = f;
        const std::size_t i = object_of(function);
        text += fmt::format("\nob={}\nfl={}\nfn=({}) {}\n0 {}\n", object(i).file.string(),
                            source_of(i), f + 1, name_in(i, function), own_[f]);
        for (; edge != edges.end() && edge->first.first == f; ++edge) {
            std::size_t callee = edge->first.second;
            const std::size_t of = object_of(callee);
            if (of != i)
                text += fmt::format("cob={}\ncfi={}\n", object(of).file.string(), source_of(of));
            text += fmt::format("cfn=({}) {}\ncalls={} 0\n0 {}\n", edge->first.second + 1,
                                name_in(of, callee), edge->second.calls, edge->second.instructions);
        }
    }
    return text;
}

}  // namespace sim
