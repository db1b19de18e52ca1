#include "sim/live/parts_view.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "sim/files/png.h"
#include "sim/page/html.h"
#include "sim/scenario/observations.h"

namespace sim::live {

using nlohmann::json;

namespace {

constexpr std::uint64_t DISPLAY_PERIOD_PS = 16'000'000'000;

}  // namespace

PartsView::PartsView(Parts& parts, const std::vector<PartPlan>& plans, Wire& wire) : wire_{wire} {
    json all;
    for (const PartPlan& plan : plans) {
        if (!plan.hang) continue;
        json& one = all[plan.name] = {{"kind", plan.kind}};
        if (const auto& control = plan.control) {
            one["on"] = json::parse(control->step(plan.name, true));
            one["off"] = json::parse(control->step(plan.name, false));
            one["stays"] = control->stays;
        }
        shown_[plan.name].part = &parts.get(plan.name);
    }
    parts.for_each<Part>([&](const std::string& name, Part& part) {
        if (!part.picture() || all.contains(name)) return;
        shown_[name].part = &part;
        all[name]["kind"] = "display";
    });
    if (!all.empty()) wire_.send(Kind::TEXT, json{{"parts", all}}.dump());
}

void PartsView::flush(std::uint64_t time_ps, bool all) {
    json news;
    const bool displays =
        (all || time_ps >= displays_at_ps_) && wire_.unsent() <= Wire::MOST_UNSENT;
    if (displays) displays_at_ps_ = time_ps + DISPLAY_PERIOD_PS;
    for (auto& [name, shown] : shown_) {
        if (auto rows = shown.part->rows(time_ps); rows != shown.rows)
            news[name]["rows"] = shown.rows = std::move(rows);
        if (!displays) continue;
        auto picture = shown.part->picture();
        if (!picture || *picture == shown.picture) continue;
        shown.picture = std::move(*picture);
        const auto& [width, height, pixels] = shown.picture;
        news[name]["picture"] = page::data_url(encode_png(image_of(pixels, width, height)));
    }
    if (!news.empty()) wire_.send(Kind::TEXT, json{{"parts", news}}.dump());
}

}  // namespace sim::live
