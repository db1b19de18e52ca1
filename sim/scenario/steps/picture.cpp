// picture.cpp - wait-frame, expect-frame, take-screenshot: eyes on the monitor
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <regex>

#include "sim/board/part.h"
#include "sim/files/whole_file.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/printable.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

// ---- wait-frame ----

// Values besides the frame numbers, which begin with 1.
constexpr std::uint64_t NEXT = 0, NEXT_SWAP = std::numeric_limits<std::uint64_t>::max();

Reading read_frame(const YamlNode& node) {
    if (node.text == "next") return NEXT;
    if (node.text == "next-swap") return NEXT_SWAP;
    if (const auto number = is_plain(node) ? parse_whole(node.text, 1, 1'000'000) : std::nullopt)
        return *number;
    return std::nullopt;
}

const ValueType FRAME{"a frame number from 1 to 1000000, next or next-swap",
                      R"({"anyOf": [{"type": "integer", "minimum": 1, "maximum": 1000000},
                  {"enum": ["next", "next-swap"]}]})",
                      read_frame,
                      "",
                      {"next", "next-swap"}};

class WaitFrame : public Claim {
public:
    explicit WaitFrame(const Values& v)
        : frame_{v.number<std::uint64_t>("frame")}, timeout_{v.get<SimTime>("timeout")} {}

    std::string describe() const override {
        const std::string what = frame_ == NEXT        ? "the next frame"
                                 : frame_ == NEXT_SWAP ? "the next new picture"
                                                       : fmt::format("frame {}", frame_);
        return "wait for " + what + within(timeout_);
    }
    Verdict decide(BoardControl& board) const override {
        const Observations& eyes = board.observations();
        const std::uint64_t pictures = eyes.new_pictures;
        const std::uint64_t number = frame_ == NEXT ? eyes.frames + 1 : frame_;
        const bool met = board.wait_until(BoardControl::Each::FRAME, timeout_, [&] {
            return frame_ == NEXT_SWAP ? eyes.new_pictures > pictures : eyes.frames >= number;
        });
        return {met, fmt::format("{} frames shown, {} of them new pictures", eyes.frames,
                                 eyes.new_pictures)};
    }

private:
    std::uint64_t frame_;
    SimTime timeout_;
};

// ---- Which display ----

constexpr const char* MONITOR = "monitor";
Reading read_display(const YamlNode& node) { return LINE.read(node); }
const ValueType DISPLAY{"monitor or the name of a display",
                        R"({"type": "string", "pattern": "^[^\\u0000-\\u001f\\u007f]+$"})",
                        read_display};

// Of a step whose field `of` says which.
class OnDisplay {
protected:
    explicit OnDisplay(const Values& v) : display_{v.get<std::string>("of")} {}

    bool on_monitor() const { return display_ == MONITOR; }
    void need(const StaticChecks& checks) const {
        if (on_monitor())
            checks.need_on_board("VGA_HS", "the monitor");
        else
            checks.need_display(display_);
    }
    Image picture(BoardControl& board) const {
        if (on_monitor()) return board.observations().picture();
        board.catch_up();
        const DisplayPicture seen = *board.part<Part>(display_).picture();
        return image_of(seen.pixels, seen.width, seen.height);
    }
    const std::string& display() const { return display_; }
    std::string describe_display() const { return on_monitor() ? "" : " on " + display_; }

private:
    std::string display_;
};

// ---- expect-frame ----

// Of 1280 x 1024, the largest picture that the monitor shows.
const ValueType PIXELS = whole_number("a whole number from 0 to 1310720", 0, 1310720);

// A part of a picture, as one number of a list: 16 bits each for width, height, left and top.
struct Rectangle {
    std::size_t width, height, left, top;

    explicit Rectangle(std::uint64_t packed)
        : width{packed >> 48},
          height{packed >> 32 & 0xffff},
          left{packed >> 16 & 0xffff},
          top{packed & 0xffff} {}
};

// In the notation of X11 and ImageMagick.
Reading read_rectangle(const YamlNode& node) {
    static const std::regex form{"([0-9]{1,4})x([0-9]{1,4})\\+([0-9]{1,4})\\+([0-9]{1,4})"};
    std::smatch found;
    if (!std::regex_match(node.text, found, form)) return std::nullopt;
    std::uint64_t packed = 0;
    for (unsigned n = 1; n <= 4; ++n) packed = packed << 16 | std::stoul(found[n]);
    return packed >> 48 && packed >> 32 & 0xffff ? Reading{packed} : std::nullopt;
}

const ValueType RECTANGLES = [] {
    ValueType type{"a rectangle WIDTHxHEIGHT+LEFT+TOP in pixels, such as 120x16+520+4",
                   R"({"type": "string", "pattern": "^0*[1-9][0-9]{0,3}x0*[1-9][0-9]{0,3})"
                   R"(\\+[0-9]{1,4}\\+[0-9]{1,4}$"})",
                   read_rectangle};
    type.list_of = "rectangle";
    return type;
}();

// `picture` with these rectangles, as far as they are inside it, taken from `other`, of its size.
Image patched(Image picture, const Image& other, const std::vector<Rectangle>& rectangles) {
    for (const Rectangle& r : rectangles) {
        if (r.left >= picture.width) continue;
        const std::size_t width = std::min<std::size_t>(r.width, picture.width - r.left),
                          end = std::min<std::size_t>(r.top + r.height, picture.height);
        for (std::size_t y = r.top; y < end; ++y)
            std::copy_n(&other.rgb[(y * picture.width + r.left) * 3], width * 3,
                        &picture.rgb[(y * picture.width + r.left) * 3]);
    }
    return picture;
}

class ExpectFrame : public Claim, private OnDisplay {
public:
    explicit ExpectFrame(const Values& v)
        : OnDisplay{v},
          line_{v.line()},
          golden_{v.path("equals")},
          differing_pixels_{v.number<std::size_t>("differing-pixels")} {
        for (const std::uint64_t packed : v.list("ignore")) ignored_.emplace_back(packed);
    }

    std::string describe() const override {
        std::string text =
            "expect the picture " + printable(golden_.filename().string()) + describe_display();
        if (differing_pixels_) text += fmt::format(" but for {} pixels", differing_pixels_);
        for (const Rectangle& r : ignored_)
            text += fmt::format(", outside {}x{}+{}+{}", r.width, r.height, r.left, r.top);
        return text;
    }
    void check(StaticChecks& checks) const override { need(checks); }
    void load(Goldens goldens) override {
        if (goldens == Goldens::MAY_BE_NEW && !std::filesystem::exists(golden_)) return;
        try {
            read_png(golden_);
        } catch (const std::runtime_error& error) {  // IoError or PngError, with the path
            throw std::runtime_error(std::string{"expected a picture, got "} + error.what());
        }
    }
    Verdict decide(BoardControl& board) const override {
        const Image picture = this->picture(board);
        Image golden;
        try {
            golden = read_png(golden_);
        } catch (const std::exception& e) {
            if (!std::filesystem::exists(golden_) && board.renew(golden_, picture))
                return {true, "renewed: it was not there"};
            return {false, e.what()};
        }
        const std::string what_is_seen =
            on_monitor() ? fmt::format("frame {}", board.observations().frames) : display();
        const auto file = [&](const char* what) {
            return board.folder() / "mismatch" /
                   fmt::format("line{}_{}_{}.png", line_, golden_.stem().string(), what);
        };
        if (picture.width != golden.width || picture.height != golden.height) {
            std::string detail =
                fmt::format("{}: {} x {} pixels, but {} has {} x {}", what_is_seen, picture.width,
                            picture.height, printable(golden_.filename().string()), golden.width,
                            golden.height);
            const auto actual = file("actual"), expected = file("expected");
            if (board.save(actual, picture) && board.save(expected, golden))
                detail += "; see " + actual.string() + " and " + expected.string();
            return renewed(board, picture, detail);
        }
        const Image compared = patched(picture, golden, ignored_);
        const std::size_t different = differing_pixels(compared, golden);
        std::string detail = fmt::format("{}: {} pixels differ", what_is_seen, different);
        if (different <= differing_pixels_) return {true, detail};

        const auto actual = file("actual"), expected = file("expected"),
                   difference = file("difference");
        if (board.save(actual, picture) && board.save(expected, golden) &&
            board.save(difference, difference_image(golden, compared)))
            detail += fmt::format("; see {}, {} and {}", actual.string(), expected.string(),
                                  difference.string());
        return renewed(board, picture, detail);
    }

private:
    Verdict renewed(BoardControl& board, const Image& picture, const std::string& detail) const {
        if (!board.renew(golden_, picture)) return {false, detail};
        return {true, "renewed: " + detail};
    }

    int line_;
    std::filesystem::path golden_;
    std::size_t differing_pixels_;
    std::vector<Rectangle> ignored_;
};

// ---- take-screenshot ----

Reading read_png_name(const YamlNode& node) {
    const auto value = LINE.read(node);
    if (!value) return std::nullopt;
    const std::filesystem::path path(node.text);
    const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
    if (path.is_absolute() || climbs || path.extension() != ".png") return std::nullopt;
    return value;
}

const ValueType PNG_NAME{
    "a name such as start.png inside the output folder",
    R"({"type": "string", "pattern": "^(?!/)(?!(.*/)?\\.\\.(/|$))[^\\u0000-\\u001f\\u007f]*)"
    R"([^/\\u0000-\\u001f\\u007f]\\.png$"})",
    read_png_name,
    "",
    {},
    0,
    false,
    true};

class TakeScreenshot : public Action, private OnDisplay {
public:
    explicit TakeScreenshot(const Values& v)
        : OnDisplay{v}, save_to_{v.get<std::string>("save-to")} {}

    std::string describe() const override {
        return "take screenshot " + printable(save_to_.string()) + describe_display();
    }
    void check(StaticChecks& checks) const override {
        need(checks);
        checks.new_file(save_to_);
    }
    void act(BoardControl& board) const override {
        board.save(board.folder() / save_to_, picture(board));
    }

private:
    std::filesystem::path save_to_;  // relative to the output folder, and inside it
};

constexpr const char* OF_HELP =
    "The monitor, or a display of the parts, such as lt24, or HPS LCD on a "
    "DE10-Standard.";

}  // namespace

namespace steps {

std::vector<StepForm> picture() {
    return {
        {"wait-frame",
         "Wait for a frame on the monitor.",
         Notation::BOTH,
         {},
         {{"frame", FRAME, Need::REQUIRED, "",
           "The n-th frame since power-on (1 is the first), next: the next frame, next-swap: the "
           "next frame with a new picture."},
          {"timeout", SOME_TIME, Need::OPTIONAL, "10s",
           "Longest wait in simulated time; then the run fails."}},
         make<WaitFrame>},
        {"expect-frame",
         "Compare the picture on the monitor, or on another display, with a PNG of its size.",
         Notation::MAP,
         {},
         {{"equals", FILE_NAME, Need::REQUIRED, "", "The PNG, relative to the scenario file."},
          {"differing-pixels", PIXELS, Need::OPTIONAL, "0", "At most so many pixels may differ."},
          {"ignore", RECTANGLES, Need::OPTIONAL, "",
           "Parts of the picture that may differ, such as a time that is shown there."},
          {"of", DISPLAY, Need::OPTIONAL, MONITOR, OF_HELP}},
         make<ExpectFrame>},
        {"take-screenshot",
         "Save the picture on the monitor, or on another display, as PNG.",
         Notation::MAP,
         {},
         {{"save-to", PNG_NAME, Need::REQUIRED, "",
           "File name, relative to the output folder and inside it."},
          {"of", DISPLAY, Need::OPTIONAL, MONITOR, OF_HELP}},
         make<TakeScreenshot>},
    };
}

}  // namespace steps

}  // namespace sim
