// server.h - the page and its WebSocket, for any number of clients, and the simulation behind them.
//
// Only for who knows the token: it is in the address that is printed.  Host and Origin must be the
// server's own, so that no other page in the same browser gets in by DNS rebinding.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sim/run/description.h"

namespace sim::live {

struct ServerSettings {
    std::string address = "127.0.0.1";  // to listen at
    unsigned port = 0;                  // 0: a free one
    RunDescription run;                 // what is simulated
    std::string title;                  // of the page
    bool driven = false;  // by a program: time stands at 0, and it ends with the last client
};

// Serves until a signal, or until the last client has gone if it is driven.  `listening` gets the
// address for the browser.  The exit code of the simulation that was the last.
// std::runtime_error: the port is taken, the simulation does not start.
int serve(const ServerSettings& settings,
          const std::function<void(const std::string& url)>& listening);

}  // namespace sim::live
