// The cleaning of Verilog: no text is refused, none is lost, and lines stay where they are.
#include <algorithm>
#include <map>

#include "sim/verilog/gates.h"
#include "sim/verilog/normalise.h"
#include "sim/verilog/source.h"
#include "sim/verilog/tokens.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

using namespace sim::project;

auto lines_of(std::string_view text) { return std::count(text.begin(), text.end(), '\n'); }

void must_be_whole(std::string_view text) {
    const Tokens tokens = tokens_of(text);
    std::string_view rest = text;
    auto line = 1u;
    const auto take = [&](std::string_view part) {
        must(part.empty() || (part.data() == rest.data() && part.size() <= rest.size()),
             "tokens and gaps give the text");
        rest.remove_prefix(part.size());
        line += static_cast<unsigned>(lines_of(part));
    };
    for (const Token& token : tokens.all) {
        must(!token.text.empty(), "a token is not empty");
        take(token.gap);
        must(token.line == line, "a token is in its line");
        take(token.text);
    }
    take(tokens.tail);
    must(rest.empty(), "tokens and gaps give the text");
}

}  // namespace

void try_verilog(std::string_view input) {
    const bool system_verilog = next_byte(input) & 1;
    must_be_whole(input);
    Modules modules;
    for (const ModuleText& module : scan(input).modules) {
        must(!module.name.empty(), "a module has a name");
        must(module.line >= 1 && module.line <= lines_of(input) + 1u, "a module is in the file");
        modules.emplace(module.name, module);
    }
    PinPorts pins;
    for (const auto& [name, module] : modules) {
        pins[name] = module.outputs;
        pins[name].insert(module.inouts.begin(), module.inouts.end());
    }
    const std::string enabled = with_enables(gates_as_assignments(input, modules), pins);
    must(lines_of(enabled) == lines_of(input), "enables keep the lines");
    const OpenInputs open{{"dff", "clrn"}, {"dff", "prn"}};
    normalise(enabled, "a.v", system_verilog, open, modules, {}, pins);
    const Normalised clean = normalise(input, "a.v", system_verilog, open, modules);
    constexpr std::string_view END = "\n`end_keywords\n";
    const bool ends = clean.text.size() >= END.size() &&
                      std::string_view{clean.text}.substr(clean.text.size() - END.size()) == END;
    const auto lines = lines_of(clean.text), before = lines_of(input);
    must(lines == before || (ends && lines == before + 2), "lines stay where they are");
    for (const std::string& change : clean.changes)
        must(change.compare(0, 4, "a.v:") == 0 && lines_of(change) == 0, "a change is a line");
    must_be_whole(clean.text);
}

}  // namespace fuzz
