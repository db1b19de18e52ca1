// Floating-point functions, by Intel's "Floating-Point IP Cores User Guide" (683750); the reference
// is this machine's arithmetic, which rounds to nearest, with denormal numbers as 0.

#include "Vfloats_bench.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

template <class To, class From>
To as(From from) {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(&to, &from, sizeof to);
    return to;
}

template <class Real>
Real flushed(Real x) {
    return std::fpclassify(x) == FP_SUBNORMAL ? std::copysign(Real{0}, x) : x;
}

// Whether `bits` are the number, or, as it, no number.
template <class Bits, class Real>
testing::AssertionResult shows(Bits bits, Real expected) {
    const Real shown = as<Real>(bits);
    if (std::isnan(expected) ? std::isnan(shown) : as<Bits>(flushed(expected)) == bits)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << std::hexfloat << shown << ", not " << expected;
}

class Floats : public testing::Test {
protected:
    Floats() {
        dut.enable_i = dut.add_i = 1;
        dut.eval();
    }

    void clock(unsigned times) {
        for (; times; --times) {
            dut.clock_i = 1;
            dut.eval();
            dut.clock_i = 0;
            dut.eval();
        }
    }

    // Of each pair the numbers, after the longest pipeline; `check` sees what is shown of them.
    template <class Check>
    void each(const Check& check) {
        constexpr unsigned LONGEST = 30;
        for (const auto& [a, b] : narrow_) {
            dut.a_i = as<std::uint32_t>(a);
            dut.b_i = as<std::uint32_t>(b);
            clock(LONGEST);
            SCOPED_TRACE(testing::Message() << std::hexfloat << a << " and " << b);
            check(flushed(a), flushed(b));
            if (HasFailure()) return;
        }
    }
    template <class Check>
    void each_wide(const Check& check) {
        constexpr unsigned LONGEST = 30;
        for (const auto& [a, b] : wide_) {
            dut.wide_a_i = as<std::uint64_t>(a);
            dut.wide_b_i = as<std::uint64_t>(b);
            clock(LONGEST);
            SCOPED_TRACE(testing::Message() << std::hexfloat << a << " and " << b);
            check(flushed(a), flushed(b));
            if (HasFailure()) return;
        }
    }

    // All pairs of special numbers, and random ones: of any bits, and near each other.
    template <class Real, class Bits>
    static std::vector<std::pair<Real, Real>> pairs() {
        using Limits = std::numeric_limits<Real>;
        std::vector<Real> special;
        for (const Real x : {Real{0}, Real{1}, Real{1.5}, Real{3}, Limits::min(), Limits::max(),
                             Limits::denorm_min(), Limits::min() / 2, Limits::infinity(),
                             Limits::quiet_NaN(), 1 + Limits::epsilon(), 2 - Limits::epsilon()})
            for (const Real signed_x : {x, -x}) special.push_back(signed_x);
        std::vector<std::pair<Real, Real>> all;
        for (const Real a : special)
            for (const Real b : special) all.emplace_back(a, b);
        std::mt19937_64 random{11};
        for (unsigned i = 0; i < 1000; ++i) {
            const Bits a = static_cast<Bits>(random());
            Bits b = static_cast<Bits>(random());
            const unsigned man = Limits::digits - 1;
            if (i % 2) {  // the exponents differ by 4 at most
                const Bits stored = (Bits{1} << man) - 1;
                const Bits exponent = (a >> man) + random() % 9 - 4;
                b = (b & (Bits{1} << (8 * sizeof b - 1))) |
                    (exponent << man & ~(Bits{1} << (8 * sizeof b - 1))) | (b & stored);
            }
            all.emplace_back(as<Real>(a), as<Real>(b));
        }
        return all;
    }

    const std::vector<std::pair<float, float>> narrow_ = pairs<float, std::uint32_t>();
    const std::vector<std::pair<double, double>> wide_ = pairs<double, std::uint64_t>();
    Vfloats_bench dut;
};

// overflow, underflow, zero, nan, of a result that may be denormal, or a quotient that is too small
// for that.
unsigned flags(float exact, bool lost = false) {
    const bool infinite = std::isinf(exact);
    const bool tiny = lost || std::fpclassify(exact) == FP_SUBNORMAL;
    return (infinite ? 8u : 0) | (tiny ? 4u : 0) | (flushed(exact) == 0 ? 2u : 0) |
           (std::isnan(exact) ? 1u : 0);
}

// The result is 0 for its size alone.
bool lost(float result, float a, float b) {
    return result == 0 && a != 0 && std::isfinite(a) && b != 0 && std::isfinite(b);
}

TEST_F(Floats, AddAndSubtract) {
    each([&](float a, float b) {
        EXPECT_TRUE(shows(dut.sum_o, a + b));
        EXPECT_TRUE(shows(dut.difference_o, a - b));
        EXPECT_EQ(dut.sum_flags_o, flags(a + b));
    });
    each_wide([&](double a, double b) { EXPECT_TRUE(shows(dut.wide_sum_o, a + b)); });
}

TEST_F(Floats, SubtractWhereAddSubIsLow) {
    dut.add_i = 0;
    each([&](float a, float b) { EXPECT_TRUE(shows(dut.sum_o, a - b)); });
}

TEST_F(Floats, Multiply) {
    each([&](float a, float b) {
        EXPECT_TRUE(shows(dut.product_o, a * b));
        EXPECT_EQ(dut.product_flags_o, flags(a * b, lost(a * b, a, b)));
    });
    each_wide([&](double a, double b) { EXPECT_TRUE(shows(dut.wide_product_o, a * b)); });
}

TEST_F(Floats, Divide) {
    each([&](float a, float b) {
        EXPECT_TRUE(shows(dut.quotient_o, a / b));
        EXPECT_EQ(dut.quotient_flags_o, flags(a / b, lost(a / b, a, 1 / b)));
        EXPECT_EQ(dut.by_zero_o, b == 0 && std::isfinite(a) && a != 0);
    });
    each_wide([&](double a, double b) { EXPECT_TRUE(shows(dut.wide_quotient_o, a / b)); });
}

TEST_F(Floats, TakeSquareRoots) {
    each([&](float a, float) {
        EXPECT_TRUE(shows(dut.root_o, std::sqrt(a)));
        EXPECT_EQ(dut.root_flags_o, (std::isinf(a) && a > 0 ? 4u : 0) | (a == 0 ? 2u : 0) |
                                        (std::isnan(std::sqrt(a)) ? 1u : 0));
    });
    each_wide([&](double a, double) { EXPECT_TRUE(shows(dut.wide_root_o, std::sqrt(a))); });
}

template <class Real>
unsigned compared(Real a, Real b) {
    return (a == b) << 6 | (a != b) << 5 | (a > b) << 4 | (a >= b) << 3 | (a < b) << 2 |
           (a <= b) << 1 | (std::isnan(a) || std::isnan(b));
}

TEST_F(Floats, Compare) {
    each([&](float a, float b) { EXPECT_EQ(dut.compared_o, compared(a, b)); });
    each_wide([&](double a, double b) { EXPECT_EQ(dut.wide_compared_o, compared(a, b)); });
}

TEST_F(Floats, ComeAfterThePipeline) {
    const auto one = as<std::uint32_t>(1.0f), six = as<std::uint32_t>(6.0f);
    dut.a_i = dut.b_i = one;
    clock(30);
    dut.a_i = six;
    clock(4);
    EXPECT_TRUE(shows(dut.product_o, 1.0f));
    clock(1);
    EXPECT_TRUE(shows(dut.product_o, 6.0f));
    EXPECT_TRUE(shows(dut.sum_o, 2.0f));
    clock(1);
    EXPECT_TRUE(shows(dut.quotient_o, 6.0f));
    dut.enable_i = 0;
    clock(3);
    EXPECT_TRUE(shows(dut.sum_o, 2.0f));
    dut.enable_i = 1;
    clock(1);
    EXPECT_TRUE(shows(dut.sum_o, 7.0f));
    dut.aclr_i = 1;
    dut.eval();
    EXPECT_EQ(dut.sum_o, 0u);
}

}  // namespace
