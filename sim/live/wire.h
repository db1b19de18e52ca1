// wire.h - messages between the two processes of `de1sim live`: server and simulation.
//
// A message is a kind and some bytes, over a socket pair.  Neither side ever waits for the other:
// what does not fit into the socket is kept here, and send() says how much that is, so that a
// picture can be left out instead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sim::live {

enum class Kind : std::uint8_t { TEXT = 0, PICTURE = 1, SOUND = 2 };  // TEXT: JSON, see README.md

struct Message {
    Kind kind;
    std::string bytes;
};

class Wire {
public:
    static constexpr std::size_t MOST_UNSENT = 4u << 20;  // bytes; pictures and sound wait above

    explicit Wire(int descriptor);  // a stream socket, which it closes in the end
    ~Wire();
    Wire(const Wire&) = delete;
    Wire& operator=(const Wire&) = delete;

    void send(Kind kind, std::string_view bytes);
    std::size_t unsent() const { return out_.size() - sent_; }  // bytes

    // Sends what it can, and reads for at most `wait_ms`; false: the other side is gone.
    bool poll(int wait_ms);
    // The next message that was read.
    std::optional<Message> receive();

    int descriptor() const { return descriptor_; }

private:
    bool flush();
    bool fill();

    const int descriptor_;
    std::string out_, in_;
    std::size_t sent_ = 0, taken_ = 0;
    bool gone_ = false;
};

}  // namespace sim::live
