// step_bench.h - test fixture: a step read from its text, on a mock board that records its actions
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "sim/board/adv7180.h"
#include "sim/board/adxl345.h"
#include "sim/board/ltc2308.h"
#include "sim/board/parts.h"
#include "sim/board/ps2_keyboard.h"
#include "sim/board/ps2_mouse.h"
#include "sim/board/remote_control.h"
#include "sim/board/sound_source.h"
#include "sim/board/usb_ports.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/scenario.h"

namespace tb {

// "": as by default, or no switch.
inline std::string bounces(const sim::Controls& c, sim::SimTime time) {
    constexpr std::uint64_t DEFAULT_PS = 500'000'000;
    return c.switches && time.ps != DEFAULT_PS ? " bounces " + to_string(time) : "";
}

// Time passes in milliseconds; after each `meanwhile` happens.
class RecordingBoard : public sim::BoardControl {
public:
    RecordingBoard() {
        hang({});
        keyboard.set_listener([this](std::uint16_t key, bool down) {
            done.push_back(fmt::format("key {:04X} {}", key, down ? "down" : "up"));
        });
        mouse.set_listener(
            {[this](int right, int up) {
                 mouse_right += right;
                 mouse_up += up;
             },
             [this](int notches) { done.push_back(fmt::format("wheel {}", notches)); },
             [this](sim::MouseButton button, bool down) {
                 done.push_back(
                     fmt::format("button {} {}", static_cast<int>(button), down ? "down" : "up"));
             }});
        usb.keyboard.on_key([this](std::uint16_t key, bool down) {
            done.push_back(fmt::format("USB key {:04X} {}", key, down ? "down" : "up"));
        });
        sim::UsbMouse::Listener hand;
        hand.move = [this](int right, int up) {
            done.push_back(fmt::format("USB mouse {} {}", right, up));
        };
        hand.turn = [this](int notches) { done.push_back(fmt::format("USB wheel {}", notches)); };
        hand.button = [this](sim::MouseButton button, bool down) {
            done.push_back(
                fmt::format("USB button {} {}", static_cast<int>(button), down ? "down" : "up"));
        };
        usb.mouse.on_hand(hand);
        for (std::size_t i = 0; i < usb.gamepads.size(); ++i) {
            hear(i == 0 ? "pad" : "pad 2", usb.gamepads[i]);
            hear(i == 0 ? "snes" : "snes 2", usb.snes_gamepads[i]);
        }
    }

    std::vector<std::string> done;  // "wait 80ms"
    std::vector<std::pair<std::string, sim::Image>> saved;
    sim::Observations seen;
    std::map<std::string, sim::ConsoleText> terminals;
    std::uint16_t leds = 0;
    bool lit = false;
    sim::HeaderMasks pins{};
    int mouse_right = 0, mouse_up = 0;
    sim::HexSegments segments{};
    std::function<void()> meanwhile = [] {};
    bool disk_full = false, renews = false;

    std::uint64_t now_ms() const { return now_ps_ / MS; }
    // The parts of a scenario, in place of those before.
    void hang(const std::vector<sim::PartPlan>& plans) {
        parts.emplace(plans, sim::PartSocket{agenda,
                                             [this](const auto& both, sim::PinLevel level) {
                                                 drive_pins(both, level);
                                             },
                                             [] {}});
        const std::initializer_list<std::pair<const char*, sim::Part&>> OF_THE_BOARD{
            {"PS/2 keyboard", keyboard},
            {"PS/2 mouse", mouse},
            {"remote control", remote},
            {"LINE IN", line_in},
            {"microphone input", microphone},
            {"video decoder", decoder},
            {"AD converter", converter},
            {"motion sensor", motion},
            {"USB keyboard", usb.keyboard},
            {"USB mouse", usb.mouse},
            {"USB ports", usb}};
        for (const auto& [name, part] : OF_THE_BOARD) parts->add(name, part);
        done.clear();
    }

    sim::Agenda agenda;
    sim::Ps2Keyboard keyboard{agenda, [] {}};
    sim::Ps2Mouse mouse{agenda, [] {}};
    sim::UsbPorts usb{agenda, {}};
    std::vector<std::uint64_t> remote_ps;  // when it begins and ends to send light
    sim::RemoteControl remote{agenda, [this] { remote_ps.push_back(agenda.now_ps()); }};
    sim::SoundSource line_in, microphone;
    sim::Adv7180 decoder;
    sim::Ltc2308 converter;
    struct Motion : sim::MotionSensor {
        sim::Adxl345::Acceleration felt{};
        void move(const sim::Adxl345::Acceleration& acceleration) override { felt = acceleration; }
    } motion;
    std::optional<sim::Parts> parts;

    void wait(sim::SimTime time) override {
        done.push_back("wait " + to_string(time));
        pass(now_ps_ + time.ps);
    }
    bool wait_until(Each, sim::SimTime timeout, const std::function<bool()>& met) override {
        const std::uint64_t end = now_ps_ + timeout.ps;
        for (;;) {
            if (met()) return true;
            if (now_ps_ >= end) return false;
            pass(std::min(end, now_ps_ + MS));
        }
    }
    void hold(const sim::Controls& c, sim::SimTime bounce) override {
        done.push_back("hold " + to_string(c) + bounces(c, bounce));
    }
    void release(const sim::Controls& c, sim::SimTime bounce) override {
        done.push_back("release " + to_string(c) + bounces(c, bounce));
    }
    void drive_pins(const sim::HeaderMasks& both, sim::PinLevel level) override {
        done.push_back(fmt::format("pins {:X} {:X} {}", both[0], both[1], static_cast<int>(level)));
    }
    void type_serial(const std::string& text, std::optional<sim::SerialLine> to) override {
        const std::string line = to ? sim::SERIAL_LINES[static_cast<std::size_t>(*to)] : "serial";
        done.push_back((to ? "to " : "") + line + " " + text);
    }
    sim::Observations& observations() override { return seen; }
    sim::ConsoleText& terminal(const std::string& part) override { return terminals[part]; }
    std::uint32_t ledr() override { return leds; }
    sim::HexSegments hex() override { return segments; }
    bool hps_led() override { return lit; }
    sim::HeaderMasks header_levels() override { return pins; }
    void act(std::function<void()> action) override { action(); }
    void press(const std::string&, std::function<void()> action) override { action(); }
    void let_go(const std::string&, std::function<void()> action) override { action(); }
    void catch_up() override {}
    std::uint64_t now_ps() const override { return now_ps_; }
    const std::filesystem::path& folder() const override { return folder_; }
    bool save(const std::filesystem::path& path, const sim::Image& image) override {
        if (!disk_full) saved.emplace_back(path.string(), image);
        return !disk_full;
    }
    bool renew(const std::filesystem::path& golden, const sim::Image&) override {
        if (renews) done.push_back("renew " + golden.filename().string());
        return renews;
    }

private:
    static constexpr std::uint64_t MS = 1'000'000'000;  // in ps

    void hear(const std::string& name, sim::UsbGamepad& gamepad) {
        sim::UsbGamepad::Listener thumbs;
        thumbs.button = [this, name](unsigned number, bool down) {
            done.push_back(fmt::format("{} button {} {}", name, number, down ? "down" : "up"));
        };
        thumbs.axes = [this, name, &gamepad] {
            done.push_back(fmt::format("{} {}", name, fmt::join(gamepad.axes(), " ")));
        };
        gamepad.on_hand(thumbs);
    }
    sim::Part& any_part(const std::string& name) override { return parts->get(name); }
    void pass(std::uint64_t until_ps) {
        while (now_ps_ < until_ps) {
            now_ps_ = std::min(until_ps, now_ps_ + MS);
            agenda.run_to(now_ps_);
            meanwhile();
        }
    }

    const std::filesystem::path folder_ = "out";
    std::uint64_t now_ps_ = 0;
};

// The only step of a scenario, in the text after "- ".
inline sim::ScenarioStep read_step(const std::string& text,
                                   const std::string& file = "tests/run.yaml") {
    const std::string head = "name: a\nversion: 1\nsteps:\n  - ";
    return std::move(sim::parse_scenario(head + text + "\n", file).steps.at(0));
}

inline std::string said(const std::string& text) { return read_step(text).text; }

class StepTest : public ::testing::Test {
protected:
    RecordingBoard board;

    std::optional<sim::Verdict> play(const std::string& text) {
        const sim::ScenarioStep step = read_step(text);
        std::optional<sim::Verdict> verdict = step.step->play(board);
        EXPECT_EQ(verdict.has_value(), step.step->decides());
        return verdict;
    }
    // Of an action: what it did.
    std::vector<std::string> acts(const std::string& text) {
        EXPECT_FALSE(play(text));
        return std::exchange(board.done, {});
    }
    // Of a claim: "met" or what was found instead.
    std::string finds(const std::string& text) {
        const auto verdict = play(text);
        if (!verdict) return "no claim";
        return verdict->met ? "met" : verdict->detail;
    }
    void show_frame(bool is_new, std::uint32_t colour = 0) {
        const std::vector<std::uint32_t> pixels(640 * 480, colour);
        board.seen.frame({++frames_, is_new, pixels, 640, 480});
    }

private:
    std::uint64_t frames_ = 0;
};

}  // namespace tb
