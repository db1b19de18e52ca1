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
#include <gmock/gmock.h>

#include "sim/board/parts.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/scenario.h"

namespace tb {

// "": as by default, or no switch.
inline std::string bounces(const sim::Controls& c, sim::SimTime time) {
    constexpr std::uint64_t DEFAULT_PS = 500'000'000;
    return c.switches && time.ps != DEFAULT_PS ? " bounces " + to_string(time) : "";
}

// Time passes in milliseconds; after each `meanwhile` happens.
class RecordingStage : public sim::BoardControl {
public:
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
    void hang(const std::vector<sim::PartPlan>& plans) {
        parts.emplace(plans, sim::PartSocket{agenda,
                                             [this](const auto& both, sim::PinLevel level) {
                                                 drive_pins(both, level);
                                             },
                                             [] {}});
        done.clear();
    }
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
    void set_voltage(unsigned channel, double volts) override {
        done.push_back(fmt::format("CH{} {} V", channel, volts));
    }
    void accelerate(double x, double y, double z) override {
        done.push_back(fmt::format("{:.2f} {:.2f} {:.2f} g", x, y, z));
    }
    void type_serial(const std::string& text, std::optional<sim::SerialLine> to) override {
        const std::string line = to ? sim::SERIAL_LINES[static_cast<std::size_t>(*to)] : "serial";
        done.push_back((to ? "to " : "") + line + " " + text);
    }
    void type_keys(const std::string& text) override { done.push_back("keys " + text); }
    void hold_key(std::uint16_t code) override {
        done.push_back(fmt::format("key {:04X} down", code));
    }
    void release_key(std::uint16_t code) override {
        done.push_back(fmt::format("key {:04X} up", code));
    }
    void press_remote(std::uint8_t button) override {
        done.push_back(fmt::format("remote {:02X}", button));
    }
    void move_mouse(int right, int up) override {
        mouse_right += right;
        mouse_up += up;
    }
    void turn_wheel(int notches) override { done.push_back(fmt::format("wheel {}", notches)); }
    void hold_button(sim::MouseButton button) override {
        done.push_back(fmt::format("button {} down", static_cast<int>(button)));
    }
    void release_button(sim::MouseButton button) override {
        done.push_back(fmt::format("button {} up", static_cast<int>(button)));
    }
    void play(sim::SoundInput input, std::shared_ptr<const sim::Recording> recording,
              bool for_ever) override {
        done.push_back(fmt::format("play {} into {} {}", recording->samples.size(),
                                   static_cast<int>(input), for_ever));
    }
    void play_tone(sim::SoundInput input, double hz, double level) override {
        done.push_back(fmt::format("tone {} {} into {}", hz, level, static_cast<int>(input)));
    }
    void play_silence(sim::SoundInput input) override {
        done.push_back(fmt::format("silence into {}", static_cast<int>(input)));
    }
    void show_picture(std::shared_ptr<const sim::Image> picture) override {
        done.push_back(fmt::format("camera {} x {}", picture->width, picture->height));
    }
    sim::Observations& observations() override { return seen; }
    sim::ConsoleText& terminal(const std::string& part) override { return terminals[part]; }
    std::uint16_t ledr() override { return leds; }
    sim::HexSegments hex() override { return segments; }
    bool hps_led() override { return lit; }
    sim::HeaderMasks header_levels() override { return pins; }
    void act(std::function<void()> action) override { action(); }
    void press(const std::string&, std::function<void()> action) override { action(); }
    void let_go(const std::string&, std::function<void()> action) override { action(); }
    std::uint64_t now_ps() override { return now_ps_; }
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

    sim::HeaderPart& header_part(const std::string& name) override { return parts->get(name); }
    void pass(std::uint64_t until_ps) {
        while (now_ps_ < until_ps) {
            now_ps_ = std::min(until_ps, now_ps_ + MS);
            agenda.run_to(now_ps_);
            meanwhile();
        }
    }

    sim::Agenda agenda;
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
    RecordingStage board;

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
