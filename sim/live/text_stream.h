// text_stream.h - what a program prints byte by byte, as pieces of UTF-8 for JSON.
#pragma once

#include <string>

namespace sim::live {

class TextStream {
public:
    void print(char character) { text_ += character; }

    // What was printed since the last call, but not the beginning of a character whose other bytes
    // are still to come.
    std::string remove();

private:
    std::string text_;
};

}  // namespace sim::live
