// error.cpp - see error.h
#include "collision/error.h"

namespace collision {

const char* text(Error error) {
    switch (error) {
        case Error::NONE: return "no error";
        case Error::NOT_FINITE: return "a coordinate is not a finite number";
        case Error::OUTSIDE_GRID: return "a coordinate is outside the grid";
        case Error::TOO_MANY_LINES: return "a polygon has too many lines";
        case Error::BOX_INSIDE_OUT: return "a box has its minimum above its maximum";
    }
    return "an unknown error";
}

}  // namespace collision
