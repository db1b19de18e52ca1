// lt24.cpp - the part lt24; expect-frame and take-screenshot of steps/picture.cpp have its picture
#include "sim/board/lt24.h"

#include "sim/scenario/part_form.h"

namespace sim {

namespace {

using namespace value_types;

PartPlan lt24(const Values& v) {
    const auto header = v.number<unsigned>("header");
    PartPlan part;
    part.pins = Lt24::pins(header);
    part.is_display = true;
    part.hang = [header](const PartSocket&) { return std::make_unique<Lt24>(header); };
    return part;
}

const ValueType HEADER = word("GPIO_0 or GPIO_1", {"GPIO_0", "GPIO_1"});

}  // namespace

namespace parts {

PartFamily lt24() {
    return {
        {
            {"lt24",
             "Terasic's LT24 display, of which expect-frame and take-screenshot have the picture.",
             Notation::BOTH,
             {},
             {{"header", HEADER, Need::REQUIRED, "", "The header that it is plugged into."}},
             sim::lt24},
        },
        {}};
}

}  // namespace parts

}  // namespace sim
