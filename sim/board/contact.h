// contact.h - the contact of a push button or a slide switch on a wire of a header
//
// Not handled: bounce.
#pragma once

#include "sim/board/header_part.h"

namespace sim {

class Contact : public HeaderPart {
public:
    struct Levels {
        PinLevel open, closed;
    };

    // Begins open.
    Contact(HeaderPin pin, Levels levels, const PartSocket& socket)
        : pin_{mask_of({pin})}, levels_{levels}, socket_{socket} {
        socket_.drive(pin_, levels_.open);
    }

    void close(bool closed) {
        socket_.drive(pin_, closed ? levels_.closed : levels_.open);
        socket_.moved();
    }

private:
    const HeaderMasks pin_;
    const Levels levels_;
    const PartSocket& socket_;
};

}  // namespace sim
