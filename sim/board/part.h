// part.h - a component on the board's pins that people act on or observe
#pragma once

namespace sim {

class Part {
public:
    virtual ~Part() = default;

protected:
    Part() = default;
    Part(const Part&) = default;
    Part& operator=(const Part&) = default;
};

}  // namespace sim
