// step_form.h - how a step is written in a scenario file: its name, its fields, its help
//
// The reader, its messages and scenario.schema.json all come from these.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/step.h"
#include "sim/scenario/value_types.h"

namespace sim {

enum class Need { REQUIRED, OPTIONAL };

struct Field {
    const char* name;
    const ValueType& type;
    Need need;
    const char* preset;  // as written in a file; "" = none
    const char* help;
};

// The values of a map's fields, presets filled in.
class Values {
public:
    // Of a step in this line of a file in `folder`.
    Values(std::filesystem::path folder, int line) : folder_{std::move(folder)}, line_{line} {}

    void set(std::string name, Value value) {
        values_.emplace_back(std::move(name), std::move(value));
    }
    const Value* find(const std::string& name) const {
        for (const auto& [key, value] : values_)
            if (key == name) return &value;
        return nullptr;
    }
    template <class T>
    T get(const std::string& name, T otherwise = {}) const {
        const Value* value = find(name);
        return value ? std::get<T>(*value) : otherwise;
    }
    template <class Number>
    Number number(const std::string& name) const {
        return static_cast<Number>(get<std::uint64_t>(name));
    }
    // A list of numbers, and the same as a mask.
    Numbers list(const std::string& name) const { return get<Numbers>(name); }
    template <class Mask>
    Mask mask(const std::string& name) const {
        std::uint64_t bits = 0;
        for (const std::uint64_t number : list(name)) bits |= std::uint64_t{1} << number;
        return static_cast<Mask>(bits);
    }
    // A file named as seen from the scenario's.
    std::filesystem::path path(const std::string& name) const {
        return folder_ / get<std::string>(name);
    }

    int line() const { return line_; }

private:
    std::filesystem::path folder_;
    int line_;
    std::vector<std::pair<std::string, Value>> values_;
};

// How a step may be written: `delay: 500ms`, `hold: {key: 0}`, or either way.
enum class Notation { BARE, MAP, BOTH };

template <class Made>
struct Form {
    const char* name;
    const char* help;
    Notation notation;                // BARE: the value is that of the first field
    std::vector<const char*> any_of;  // at least one of these fields; empty = no such rule
    std::vector<Field> fields;
    Made (*make)(const Values&);
    bool only_one = false;  // of any_of
};

using StepForm = Form<std::unique_ptr<Step>>;

// For `make`: a step whose constructor takes the values.
template <class AStep>
std::unique_ptr<Step> make(const Values& values) {
    return std::make_unique<AStep>(values);
}

}  // namespace sim
