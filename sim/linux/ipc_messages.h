// ipc_messages.h - a message queue of System V: messages with types, and who waits for which.
//
// Source: Linux 6.1, ipc/msg.c.
#pragma once

#include <cstdint>
#include <list>
#include <utility>
#include <vector>

#include "sim/linux/waiting_line.h"

namespace sim {

struct IpcMessages {
    static constexpr std::uint32_t LONGEST = 8192;  // MSGMAX

    struct Message {
        std::int32_t type;
        std::vector<std::uint8_t> bytes;
    };
    // Which message a receiver takes, by msgrcv()'s type.
    struct Choice {
        std::int32_t type;
        bool but_not = false;  // MSG_EXCEPT
    };
    using Place = std::list<Message>::iterator;

    std::uint32_t key, rights;
    std::list<Message> messages{};
    std::uint32_t bytes = 0, most_bytes = 16384;  // MSGMNB
    std::uint64_t sent_ns = 0, received_ns = 0, changed_ns = 0;
    int sender = 0, receiver = 0;  // the last ones' processes
    WaitingLine senders{}, receivers{};
    bool removed = false;

    bool has_room(std::size_t for_bytes) const {
        return for_bytes + bytes <= most_bytes && messages.size() + 1 <= most_bytes;
    }
    // The first one, or with a type below 0 the first of the lowest; or the end.
    Place find(const Choice& choice) {
        const std::int64_t most = -std::int64_t{choice.type};
        Place best = messages.end();
        for (Place it = messages.begin(); it != messages.end(); ++it) {
            const bool fits = choice.type == 0  ? true
                              : choice.type < 0 ? it->type <= most
                              : choice.but_not  ? it->type != choice.type
                                                : it->type == choice.type;
            if (!fits) continue;
            if (choice.type >= 0) return it;
            if (best == messages.end() || it->type < best->type) best = it;
        }
        return best;
    }
};

}  // namespace sim
