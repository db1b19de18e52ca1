#include "sim/live/live_view.h"

#include <algorithm>
#include <chrono>

#include <nlohmann/json.hpp>

#include "sim/live/picture.h"
#include "sim/scenario/seven_segment.h"

namespace sim::live {

namespace {

nlohmann::json as_json(const Lamps& lamps) {
    nlohmann::json hex = nlohmann::json::array(), gpio = nlohmann::json::array();
    const HexSegments segments = segments_of(lamps.hex);
    for (const std::uint8_t digit : segments) hex.push_back(digit);
    for (const Lamps::Header& header : lamps.gpio)
        gpio.push_back({{"levels", header.levels}, {"outputs", header.outputs}});
    return {{"lamps",
             {{"ledr", lamps.ledr},
              {"hex", hex},
              {"hex_text", hex_text(segments)},
              {"hps_led", lamps.hps_led},
              {"gpio", gpio}}}};
}

// JSON is UTF-8; other bytes become U+FFFD.
std::string text_of(const nlohmann::json& json) {
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void LiveView::frame(const Monitor::Frame& frame) {
    recorder_.frame(frame);
    on_frame();
    ++frames_;
    if (frame.is_new) ++new_pictures_;
    if (frame.is_new || sent_.empty()) send_picture(frame);
}

bool LiveView::has_room() {
    while (waits_ && wire_.unsent() > Wire::MOST_UNSENT && wire_.poll(50)) {
    }
    return wire_.unsent() <= Wire::MOST_UNSENT;
}

void LiveView::send_picture(const Monitor::Frame& frame) {
    if (!has_room()) {
        sent_.clear();  // the next one is whole
        return;
    }
    const bool whole = sent_.empty() || width_ != frame.width || height_ != frame.height;
    if (whole) {
        width_ = frame.width;
        height_ = frame.height;
        sent_ = frame.pixels;
    }
    std::string bytes;
    put(bytes, width_, 2);
    put(bytes, height_, 2);
    put(bytes, static_cast<std::uint32_t>(frame.number), 4);
    for (unsigned top = 0, number = 0; top < height_; top += TILE) {
        for (unsigned left = 0; left < width_; left += TILE, ++number) {
            const unsigned columns = std::min(TILE, width_ - left),
                           rows = std::min(TILE, height_ - top);
            bool differs = whole;
            for (unsigned y = 0; y < rows && !differs; ++y) {
                const std::size_t at = std::size_t{top + y} * width_ + left;
                differs = !std::equal(&frame.pixels[at], &frame.pixels[at] + columns, &sent_[at]);
            }
            if (!differs) continue;
            put(bytes, number, 2);
            for (unsigned y = 0; y < TILE; ++y)
                for (unsigned x = 0; x < TILE; ++x) {
                    std::uint32_t rgb = 0;
                    if (y < rows && x < columns) {
                        const std::size_t at = std::size_t{top + y} * width_ + left + x;
                        rgb = sent_[at] = frame.pixels[at];
                    }
                    bytes += static_cast<char>(rgb >> 16);
                    bytes += static_cast<char>(rgb >> 8);
                    bytes += static_cast<char>(rgb);
                }
        }
    }
    wire_.send(Kind::PICTURE, bytes);
    sent_frame_ = frame.number;
}

void LiveView::sample(std::int16_t left, std::int16_t right) {
    recorder_.sample(left, right);
    put(sound_, static_cast<std::uint16_t>(left), 2);
    put(sound_, static_cast<std::uint16_t>(right), 2);
}

void LiveView::sample_rate(double hz) {
    recorder_.sample_rate(hz);
    rate_hz_ = hz;
}

void LiveView::console(char character, SerialLine line) {
    recorder_.console(character, line);
    console_.print(character);
    ++printed_;
    terminals_[static_cast<std::size_t>(line)].print(character);
}

void LiveView::terminal(const std::string& part, char character) {
    part_terminals_[part].print(character);
    ++printed_;
}

void LiveView::lamps(const Lamps& lamps, double time_s) {
    recorder_.lamps(lamps, time_s);
    const bool lit_otherwise =
        lamps.ledr != lamps_.ledr || lamps.hex != lamps_.hex || lamps.hps_led != lamps_.hps_led;
    if (lit_otherwise) ++lamps_seen_;
    if (lamps.gpio != lamps_.gpio) ++pins_seen_;
    lamps_ = lamps;
    lamps_moved_ = true;
}

void LiveView::log(const std::string& line) {
    recorder_.log(line);
    wire_.send(Kind::TEXT, text_of({{"log", line}}));
}

void LiveView::flush() {
    if (!sound_.empty() && has_room()) {
        std::string bytes;
        put(bytes, static_cast<std::uint32_t>(rate_hz_ + 0.5), 4);
        wire_.send(Kind::SOUND, bytes + sound_);
    }
    sound_.clear();
    const std::string console = console_.remove();
    if (!console.empty()) wire_.send(Kind::TEXT, text_of({{"console", console}}));
    nlohmann::json terminals = nlohmann::json::object();
    for (std::size_t n = 0; n < terminals_.size(); ++n)
        if (std::string text = terminals_[n].remove(); !text.empty())
            terminals[SERIAL_LINES[n]] = std::move(text);
    for (auto& [part, stream] : part_terminals_)
        if (std::string text = stream.remove(); !text.empty()) terminals[part] = std::move(text);
    if (!terminals.empty()) wire_.send(Kind::TEXT, text_of({{"terminals", terminals}}));
    if (lamps_moved_) wire_.send(Kind::TEXT, text_of(as_json(lamps_)));
    lamps_moved_ = false;
}

void LiveView::end(const std::vector<std::string>& faults) {
    flush();
    for (const std::string& fault : faults) wire_.send(Kind::TEXT, text_of({{"fault", fault}}));
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds{1};
    while (wire_.unsent() && std::chrono::steady_clock::now() < limit && wire_.poll(100)) {
    }
}

}  // namespace sim::live
