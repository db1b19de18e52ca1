// say.cpp - a step as a person would say it
#include <fmt/format.h>

#include <bitset>

#include "sim/report/printable.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/words.h"

namespace sim {

namespace {

std::string within(SimTime timeout) {
    return timeout.ps == 0 ? "" : " within " + to_string(timeout);
}

struct Speaker {
    std::string operator()(const Delay& s) const { return "wait " + to_string(s.time); }
    std::string operator()(const Press& s) const {
        return fmt::format("press {} for {}", to_string(s.controls), to_string(s.time));
    }
    std::string operator()(const Hold& s) const { return "hold " + to_string(s.controls); }
    std::string operator()(const Release& s) const { return "release " + to_string(s.controls); }
    std::string operator()(const TypeSerial& s) const { return "type " + in_quotes(s.text); }
    std::string operator()(const SetVoltage& s) const {
        return fmt::format("apply {:.6g} V to CH{}", s.volts, s.channel);
    }
    std::string operator()(const TypeKeys& s) const {
        return "type " + in_quotes(s.text) + " on the keyboard";
    }
    std::string operator()(const WaitFrame& s) const {
        const std::string what = s.what == WaitFrame::What::NUMBER
                                     ? fmt::format("frame {}", s.number)
                                 : s.what == WaitFrame::What::NEXT ? "the next frame"
                                                                   : "the next new picture";
        return "wait for " + what + within(s.timeout);
    }
    std::string operator()(const WaitSerial& s) const {
        return "wait for " + in_quotes(s.text) + " on the serial line" + within(s.timeout);
    }
    std::string operator()(const ExpectFrame& s) const {
        std::string text = "expect the picture " + printable(s.golden.filename().string());
        if (s.differing_pixels) text += fmt::format(" but for {} pixels", s.differing_pixels);
        return text;
    }
    std::string operator()(const ExpectTone& s) const {
        return fmt::format("expect a tone of {} Hz, give or take {:.6g}%, for {}{}", s.hz,
                           s.within * 100, to_string(s.time), within(s.timeout));
    }
    std::string operator()(const ExpectSilence& s) const {
        return "expect silence for " + to_string(s.time);
    }
    std::string operator()(const ExpectLeds& s) const {
        return "expect LEDs " + std::bitset<10>(s.leds).to_string() + within(s.timeout);
    }
    std::string operator()(const ExpectHex& s) const {
        return "expect \"" + s.text + "\" on HEX" + within(s.timeout);
    }
    std::string operator()(const TakeScreenshot& s) const {
        return "take screenshot " + printable(s.save_to.string());
    }
};

}  // namespace

std::string say(const Action& action) { return std::visit(Speaker{}, action); }

}  // namespace sim
