// Messages of de1sim live, as far as no simulation is needed: the first byte says which.
//
// Not here: LivePlayer::take(), which reads the orders of a person, is a part of a SystemC module.
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/live/exact_run.h"
#include "sim/live/greeting.h"
#include "sim/live/text_stream.h"
#include "sim/live/wire.h"
#include "sim/text/printable.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

namespace {

using namespace sim::live;

// Text in pieces, whose lengths are in its bytes.
void try_text(std::string_view text) {
    const bool whole = sim::is_utf8(text);
    TextStream stream;
    std::string taken;
    for (const char c : text) {
        stream.print(c);
        if (static_cast<unsigned char>(c) % 3 == 0) continue;
        const std::string piece = stream.remove();
        must(!whole || sim::is_utf8(piece), "a piece of a text in UTF-8 is in UTF-8");
        taken += piece;
    }
    taken += stream.remove();
    must(text.substr(0, taken.size()) == taken, "nothing is changed");
    must(text.size() - taken.size() <= 3, "at most a part of a character is kept");
    must(!whole || taken == text, "nothing is lost");
}

// The bytes that arrive are cut into messages; these sent back make the same bytes.
void try_wire(std::string_view bytes) {
    int ends[2];
    must(socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0, "there is a pair of sockets");
    Wire wire{ends[0]};
    std::string again;
    while (!bytes.empty()) {
        const std::size_t length = std::min<std::size_t>(bytes.size(), 1 + bytes[0] % 64u);
        must(write(ends[1], bytes.data(), length) == static_cast<ssize_t>(length), "it is sent");
        bytes.remove_prefix(length);
        must(wire.poll(0), "the other side is there");
        while (const auto message = wire.receive()) {
            wire.send(message->kind, message->bytes);
            char back[8192];
            const ssize_t count = read(ends[1], back, sizeof back);
            must(count == static_cast<ssize_t>(message->bytes.size() + 5), "it comes back");
            std::uint32_t told;
            std::memcpy(&told, back, sizeof told);
            must(told == message->bytes.size(), "a message says its length");
        }
    }
    close(ends[1]);
    wire.poll(0);
    must(!wire.poll(0), "a side that has gone is noticed");
}

void try_run(std::string_view text) {
    const auto order = nlohmann::json::parse(text, nullptr, false);
    if (order.is_discarded()) return;
    try {
        const ExactRun run{order, {}, sc_core::SC_ZERO_TIME};
        must(run.over({}, sc_core::sc_time{10, sc_core::SC_SEC}), "no run is longer than 10 s");
        must(run.met({}).empty(), "nothing has happened yet");
        ExactRun::Counts all{1, 1, 1, 1, 1, true};
        must(run.met(all).empty() || run.over(all, sc_core::SC_ZERO_TIME), "what is met ends it");
    } catch (const std::runtime_error& error) {
        must(std::strncmp(error.what(), "run: expected ", 14) == 0, "a refusal says what it wants");
    }
}

void try_greeting(std::string_view text) {
    Greeting greeting;
    try {
        for (unsigned i = 0; i < 30; ++i) greeting.add(std::string{next_line(text)});
    } catch (const nlohmann::json::type_error&) {  // which no text from the simulation is
    }
    const auto texts = greeting.texts();
    must(texts.size() <= 23, "a greeting has an end");
    for (const std::string& message : texts)
        must(nlohmann::json::accept(message), "a greeting is JSON");
}

}  // namespace

void try_live(std::string_view input) {
    switch (next_byte(input) % 4) {
        case 0: return try_text(input);
        case 1: return try_wire(input);
        case 2: return try_run(input);
        default: return try_greeting(input);
    }
}

}  // namespace fuzz
