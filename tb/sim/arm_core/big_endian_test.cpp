// Big-endian data on the bus, by CPSR.E (ARM ARM, A3.3).  In RAM it is compared with Unicorn's.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace big_endian {

using namespace tb::core;

class BigEndian : public SystemTest {};

// The same instruction several times: at its first execution it is translated as if it accessed
// RAM.
TEST_P(BigEndian, TurnsWhatIsOnTheBusEachTime) {
    const auto on_bus = [&] { return bench.accesses.back().value; };
    const auto turned = [](std::uint32_t value) {
        return __builtin_bswap16(static_cast<std::uint16_t>(value));
    };
    const struct {
        Both words;  // r2, [r1]
        std::function<void()> check;
    } accesses[] = {
        {{0xE5912000, 0x680A}, [&] { EXPECT_EQ(reg(2), __builtin_bswap32(on_bus())); }},  // LDR
        {{0xE1D120F0, 0xF9B12000},                                                        // LDRSH
         [&] {
             EXPECT_EQ(static_cast<std::int32_t>(reg(2)),
                       static_cast<std::int16_t>(turned(on_bus())));
         }},
        {{0xE5812000, 0x600A}, [&] { EXPECT_EQ(on_bus(), __builtin_bswap32(reg(2))); }},  // STR
        {{0xE1C120B0, 0x800A}, [&] { EXPECT_EQ(on_bus(), turned(reg(2))); }},             // STRH
        {{0xE5C12000, 0x700A}, [&] { EXPECT_EQ(on_bus(), reg(2) & 0xFF); }},              // STRB
    };
    become(SVC | E);
    set(1, BUS);
    for (const auto& access : accesses)
        for (unsigned again = 0; again < 5; ++again) {
            SCOPED_TRACE(access.words.arm);
            set(2, 0xAABBCCDD);
            set(15, AT);
            if (!again) put(access.words);
            ASSERT_EQ(run(), sim::ArmStop::WFI);
            access.check();
        }
}

INSTANTIATE_TEST_SUITE_P(In, BigEndian, EACH_WAY, name_of_way);

}  // namespace big_endian
