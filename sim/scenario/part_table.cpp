// part_table.cpp - one list of the lists in parts/
#include "sim/scenario/part_table.h"

#include <iterator>
#include <map>

#include <fmt/format.h>

#include "sim/text/words.h"

namespace sim {

// part_families.def has a line for each file of parts/, made by CMake.
namespace parts {
#define FAMILY(name) PartFamily name();
#include "part_families.def"
#undef FAMILY
}  // namespace parts

namespace {

const PartFamily& all_families() {
    static const PartFamily ALL = [] {
        PartFamily all;
        for (auto* family : {
#define FAMILY(name) &parts::name,
#include "part_families.def"
#undef FAMILY
             }) {
            PartFamily one = family();
            std::move(one.parts.begin(), one.parts.end(), std::back_inserter(all.parts));
            std::move(one.steps.begin(), one.steps.end(), std::back_inserter(all.steps));
        }
        return all;
    }();
    return ALL;
}

}  // namespace

const std::vector<PartForm>& part_forms() { return all_families().parts; }

const std::vector<StepForm>& steps_on_parts() { return all_families().steps; }

void check_parts(const std::vector<PartPlan>& parts) {
    std::map<std::string, int> names;
    std::map<HeaderPin, const PartPlan*> pins;
    const auto refuse = [](const PartPlan& part, const std::string& expected,
                           const std::string& got) {
        throw Refusal{part.line, part.column, "expected " + expected + ", got " + got};
    };
    for (const PartPlan& part : parts) {
        const auto [name, is_new] = names.emplace(part.name, part.line);
        if (!is_new)
            refuse(part, "a new name for each part",
                   fmt::format("{} again, first in line {}", in_quotes(part.name), name->second));
        for (const auto* list : {&part.shared, &part.pins})
            for (const HeaderPin pin : *list) {
                const auto [other, is_free] = pins.emplace(pin, &part);
                const PartPlan& has = *other->second;
                if (is_free || (list == &part.shared && &has != &part && has.shared == part.shared))
                    continue;
                refuse(part, "pins that are free",
                       other->second == &part
                           ? pin_name(pin) + " twice"
                           : fmt::format("{}, which {} of line {} has", pin_name(pin),
                                         other->second->name, other->second->line));
            }
    }
}

}  // namespace sim
