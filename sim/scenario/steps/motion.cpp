// motion.cpp - tilt-board, accelerate-board: what the board's accelerometer feels
//
// x points to the right edge, y to the far one, z up, as the board lies before a person.
#include <fmt/format.h>

#include <cmath>

#include "sim/board/adxl345.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

using namespace value_types;

void accelerate(BoardControl& board, const Adxl345::Acceleration& acceleration) {
    board.part<MotionSensor>("motion sensor").move(acceleration);
}

class TiltBoard : public Action {
public:
    explicit TiltBoard(const Values& v)
        : right_{v.get<double>("right")}, towards_{v.get<double>("towards")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("MOTION", "the motion sensor");
    }
    std::string describe() const override {
        return fmt::format("tilt the board {:.6g} degrees to the right and {:.6g} towards you",
                           right_, towards_);
    }
    // At rest it feels what holds it up: 1 g, upwards.
    void act(BoardControl& board) const override {
        constexpr double PER_DEGREE = 3.14159265358979323846 / 180;
        const double right = right_ * PER_DEGREE, towards = towards_ * PER_DEGREE;
        accelerate(board, {-std::sin(right) * std::cos(towards), std::sin(towards),
                           std::cos(right) * std::cos(towards)});
    }

private:
    double right_, towards_;
};

class AccelerateBoard : public Action {
public:
    explicit AccelerateBoard(const Values& v)
        : x_{v.get<double>("x")}, y_{v.get<double>("y")}, z_{v.get<double>("z")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("MOTION", "the motion sensor");
    }
    std::string describe() const override {
        return fmt::format("accelerate the board by {:.6g}, {:.6g}, {:.6g} g", x_, y_, z_);
    }
    void act(BoardControl& board) const override { accelerate(board, {x_, y_, z_}); }

private:
    double x_, y_, z_;
};

const ValueType DEGREES = decimal_number("a number of degrees, -180 to 180", -180, 180);
const ValueType G = decimal_number("a number of g, -20 to 20", -20, 20);

}  // namespace

namespace steps {

std::vector<StepForm> motion() {
    return {
        {"tilt-board",
         "Tilt the board, which begins flat, and go on; the accelerometer feels it, on I2C0 of the "
         "HPS or, on a DE10-Lite, on pins of the FPGA. "
         "x points to the right edge, y to the far one, z up; how the chip is turned on a board is "
         "to "
         "be tried there.",
         Notation::MAP,
         {},
         {{"right", DEGREES, Need::OPTIONAL, "0", "The right edge goes down by so much."},
          {"towards", DEGREES, Need::OPTIONAL, "0", "The near edge goes down by so much."}},
         make<TiltBoard>},
        {"accelerate-board",
         "What the accelerometer measures from now on, as when the board is shaken or falls; it "
         "rests "
         "flat with 0, 0, 1.",
         Notation::MAP,
         {},
         {{"x", G, Need::OPTIONAL, "0", "To the right."},
          {"y", G, Need::OPTIONAL, "0", "Away from you."},
          {"z", G, Need::OPTIONAL, "1", "Up."}},
         make<AccelerateBoard>},
    };
}

}  // namespace steps

}  // namespace sim
