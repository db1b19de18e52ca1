#include "tb/fuzz/collision/world.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "collision/contact.h"
#include "collision/detector.h"
#include "collision/fixed_box.h"
#include "collision/grid.h"
#include "collision/turn.h"

namespace fuzz {

namespace {

using namespace collision;

// Reads the bytes, and zeros after their end.
class Bytes {
public:
    Bytes(const std::uint8_t* bytes, std::size_t count) : at_{bytes}, left_{count} {}

    template <class Value>
    Value next() {
        Value value{};
        const std::size_t size = std::min(left_, sizeof value);
        if (size) std::memcpy(&value, at_, size);
        at_ += size;
        left_ -= size;
        return value;
    }

    bool empty() const { return left_ == 0; }

private:
    const std::uint8_t* at_;
    std::size_t left_;
};

void require(bool holds) {
    if (!holds) std::abort();
}

// Small coordinates half of the time, so that shapes meet.
Vec2 any_point(Bytes& bytes, unsigned kind) {
    if (kind & 1) return {bytes.next<std::int8_t>(), bytes.next<std::int8_t>()};
    return {bytes.next<std::int32_t>(), bytes.next<std::int32_t>()};
}

struct Made {
    Polygon polygon;
    bool sound = true;  // its box contains its lines
};

Made any_polygon(Bytes& bytes) {
    Made made;
    const auto kind = bytes.next<std::uint8_t>();
    Vec2 corners[Polygon::MAX_LINES + 4];
    const unsigned count = bytes.next<std::uint8_t>() % (Polygon::MAX_LINES + 5);
    for (unsigned i = 0; i < count; ++i) {
        corners[i] = any_point(bytes, kind);
        if (kind & 2 &&
            to_grid(bytes.next<double>(), bytes.next<float>(), corners[i]) == Error::NONE)
            require(on_grid(corners[i]));
    }
    Polygon& polygon = made.polygon;
    if (polygon.outline(corners, count) != Error::NONE) require(polygon.count == 0);
    if (kind & 4) polygon = moved(polygon, any_point(bytes, kind));
    if (kind & 8) {
        const Turn turn = {bytes.next<std::int16_t>(), bytes.next<std::int16_t>()};
        polygon = turned(polygon, any_point(bytes, kind), turn);
    }
    if (kind & 16) (void)fixed_box(polygon, any_point(bytes, kind), polygon.aabb);
    if (kind & 32) {
        polygon.lines[bytes.next<std::uint8_t>() % Polygon::MAX_LINES].a = any_point(bytes, kind);
        made.sound = false;
    }
    if (kind & 64) {
        polygon.aabb = {any_point(bytes, kind), any_point(bytes, kind)};
        made.sound = false;
    }
    if (kind & 128) {
        polygon.count = bytes.next<std::uint8_t>();
        made.sound = false;
    }
    return made;
}

}  // namespace

void try_world(const std::uint8_t* data, std::size_t count, std::size_t most_with_all) {
    Bytes bytes{data, count};
    std::vector<Polygon> shapes;
    bool sound = true;
    while (!bytes.empty() && shapes.size() < 300) {
        const Made made = any_polygon(bytes);
        shapes.push_back(made.polygon);
        sound = sound && made.sound;
    }
    Detector detector;
    PairList first, pairs;
    const Error expected = detector.find(Algorithm::ORIGINAL, shapes, first);
    for (const Algorithm algorithm : ALGORITHMS) {
        if (algorithm < Algorithm::SWEEP && shapes.size() > most_with_all) continue;
        const Error error = detector.find(algorithm, shapes, pairs);
        require(error == expected);
        require(error == Error::NONE || pairs.empty());
        require(!sound || pairs == first);
        for (const CollisionPair pair : pairs)
            require(pair.first < pair.second && pair.second < shapes.size());
    }
    std::vector<Contact> contacts;
    find_contacts(shapes, pairs, contacts);
    require(!sound || contacts.size() == pairs.size());
}

}  // namespace fuzz
