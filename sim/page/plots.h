// plots.h - a run over time, as SVG in a page; all plots are of the same width and time
#pragma once

#include <string>

#include "sim/page/page.h"

namespace sim::page {

// Each is empty if there is nothing to show.
std::string step_plot(const Page& page, double end_s);
std::string sound_plot(const SoundLog& sound, double end_s);
std::string lamp_plot(const std::vector<RunReport::Shown>& shown, double end_s);
std::string frame_plot(const std::vector<FrameUse>& frames, double end_s);

}  // namespace sim::page
