// page_test.cpp - the page of a run: its text is harmless, and it keeps a bounded part of all
#include "sim/page/page.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "sim/page/html.h"

namespace {

using namespace sim;
using namespace sim::page;
using testing::HasSubstr;
using testing::Not;

const std::string EVIL = "<script>alert('1')</script>&\"\x1B\xFF";
const std::string HARMLESS = "&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt;&amp;&quot;\\x1b\\xff";

std::vector<std::uint8_t> bytes(const std::string& text) { return {text.begin(), text.end()}; }

TEST(PageText, IsEscaped) { EXPECT_EQ(escape(EVIL), HARMLESS); }

TEST(PagePictures, AreInBase64) {
    EXPECT_EQ(data_url(bytes("")), "data:image/png;base64,");
    EXPECT_EQ(data_url(bytes("f")), "data:image/png;base64,Zg==");
    EXPECT_EQ(data_url(bytes("fo")), "data:image/png;base64,Zm8=");
    EXPECT_EQ(data_url(bytes("foo")), "data:image/png;base64,Zm9v");
    EXPECT_EQ(data_url(bytes("\xFF\xFE\xFD\xFC")), "data:image/png;base64,//79/A==");
}

TEST(PagePictures, AreHalfAsLargeEachPixelTheMeanOfFour) {
    const Image image{4, 3, {0, 0, 0, 4, 0, 8,   9, 9, 9, 9, 9, 9,  //
                             4, 0, 0, 8, 0, 200, 9, 9, 9, 9, 9, 9,  //
                             1, 1, 1, 1, 1, 1,   1, 1, 1, 1, 1, 1}};
    EXPECT_EQ(half_size(image), (Image{2, 1, {4, 0, 52, 9, 9, 9}}));
}

class PageFilm : public testing::Test {
protected:
    // Frame `number`, each of another grey.
    void show(std::uint64_t number) {
        const std::vector<std::uint32_t> pixels(4 * 4, static_cast<std::uint32_t>(number));
        eyes.frame({number, true, pixels, 4, 4});
        film.show(static_cast<double>(number), eyes);
    }
    std::vector<std::uint64_t> numbers() const {
        std::vector<std::uint64_t> all;
        for (const Film::Picture& picture : film.pictures()) all.push_back(picture.number);
        return all;
    }
    Observations eyes;
    Film film;
};

TEST_F(PageFilm, KeepsSomePicturesOfAllOfTheRun) {
    for (std::uint64_t number = 1; number <= 10 * Film::MOST; ++number) show(number);
    EXPECT_EQ(film.shown(), 10 * Film::MOST);
    EXPECT_LE(film.pictures().size(), Film::MOST);
    EXPECT_GT(film.pictures().size(), Film::MOST / 3);
    const std::vector<std::uint64_t> kept = numbers();
    for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_EQ(kept[i] - kept[i - 1], 16u);
}

TEST_F(PageFilm, KeepsThePicturesOfSteps) {
    EXPECT_EQ(film.keep(eyes), 0u) << "before the first picture";
    for (std::uint64_t number = 1; number <= 10 * Film::MOST; ++number) {
        show(number);
        if (number == 2 || number == 1001) {
            EXPECT_EQ(film.keep(eyes), number);
        }
    }
    EXPECT_THAT(numbers(), testing::IsSupersetOf({2u, 1001u}));
    EXPECT_TRUE(std::is_sorted(film.pictures().begin(), film.pictures().end(),
                               [](auto& a, auto& b) { return a.number < b.number; }));
}

TEST(PageSound, HasTheTonesWithTheirTimes) {
    SoundLog sound;
    sound.sample_rate(8000);
    for (int i = 0; i < 16000; ++i) {  // 440 Hz from 0.5 s to 1 s
        const double time_s = i / 8000.0;
        const double level = time_s >= 0.5 && time_s < 1 ? 8000 : 0;
        const auto value = static_cast<std::int16_t>(level * std::sin(time_s * 440 * 6.2831853));
        sound.sample(time_s, 0, value);
    }
    ASSERT_EQ(sound.tones().size(), 1u);
    EXPECT_NEAR(sound.tones()[0].hz, 440, 3);
    EXPECT_NEAR(sound.tones()[0].from_s, 0.5, 0.001);
    EXPECT_NEAR(sound.tones()[0].to_s, 1, 0.001);
    const auto at = [&](double time_s) {
        return sound.envelope().at(static_cast<std::size_t>(time_s / sound.span_s()));
    };
    EXPECT_NEAR(at(0.75).high, 8000, 100);
    EXPECT_NEAR(at(0.75).low, -8000, 100);
    EXPECT_EQ(at(0.25).high, 0);
    EXPECT_EQ(at(1.5).low, 0);
}

TEST(PageSound, HasABoundedEnvelope) {
    SoundLog sound;
    for (int i = 0; i < 1000; ++i) sound.sample(i * 0.1, 0, i == 500 ? 77 : 0);
    EXPECT_LE(sound.envelope().size(), SoundLog::MOST);
    EXPECT_EQ(sound.envelope().at(static_cast<std::size_t>(50 / sound.span_s())).high, 77);
}

TEST(PageConsole, HasTheTimeOfEachLineAndABound) {
    ConsoleLog console;
    double time_s = 0;
    for (const char c : std::string{"one\r\n\ntwo"}) console.print(time_s += 1, c);
    ASSERT_EQ(console.lines().size(), 3u);
    EXPECT_EQ(console.lines()[0].text, "one");
    EXPECT_EQ(console.lines()[1].time_s, 6);
    EXPECT_EQ(console.lines()[2].text, "two");
    EXPECT_EQ(console.lines()[2].time_s, 7);
    for (std::size_t i = 0; i < ConsoleLog::MOST_BYTES; ++i) console.print(9, 'x');
    EXPECT_EQ(console.left_out(), 9u);
}

TEST(PageOfARun, LetsNoTextBeMarkup) {
    RunReport report;
    report.scenario = report.signal = report.lamps = report.file = EVIL;
    report.simulated_s = 1;
    report.faults = report.advice = report.characters = {EVIL};
    report.checks = {{EVIL, false, EVIL}};
    report.parts = {{EVIL, {EVIL}}};
    report.shown = {{EVIL, {}, {{0.1, {{"lit", EVIL}}}}, 1}};
    Page page;
    page.command = page.version = EVIL;
    page.steps.push_back({1, EVIL, 0.1, 0.2, true, false, EVIL, 7, {{EVIL, {1, 2, 3}}}});
    for (const char c : EVIL) page.console.print(0.5, c);
    const std::string html = to_html(report, page);
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, HasSubstr(HARMLESS));
    std::size_t count = 0;
    for (std::size_t at = 0; (at = html.find(HARMLESS, at)) != html.npos; ++at) ++count;
    EXPECT_GE(count, 20u) << "all of them are there";
}

}  // namespace
