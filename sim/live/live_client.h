// live_client.h - the page of `de1sim live` as the client of its run
#pragma once

#include <optional>

#include "sim/live/inside.h"
#include "sim/live/live_player.h"
#include "sim/live/live_view.h"
#include "sim/live/parts_view.h"
#include "sim/live/wire.h"
#include "sim/run/run_client.h"

namespace sim::live {

class LiveClient final : public RunClient {
public:
    LiveClient(int socket, Recorder& recorder) : wire_{socket}, view_{recorder, wire_} {}

    BoardObserver& observer() override { return view_; }
    void attach(const Access& access) override;
    bool has_left() const override { return player_->left(); }
    void leave() override { player_->leave(); }
    void end(const std::vector<std::string>& faults) override { view_.end(faults); }

private:
    Wire wire_;
    LiveView view_;
    std::optional<Inside> inside_;
    std::optional<PartsView> parts_;
    std::optional<LivePlayer> player_;
};

}  // namespace sim::live
