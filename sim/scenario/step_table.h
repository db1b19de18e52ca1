// step_table.h - every step and field of a scenario file, once
//
// The reader, its messages and scenario.schema.json all come from this table.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/scenario/value_types.h"

namespace sim {

enum class Need { REQUIRED, OPTIONAL };

struct Field {
    const char* name;
    const ValueType& type;
    Need need;
    const char* preset;  // as the file would say it; "" = none
    const char* help;
};

// The values of a map's fields, presets filled in.
class Values {
public:
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

private:
    std::vector<std::pair<std::string, Value>> values_;
};

// How a step may be written: `delay: 500ms`, `hold: {key: 0}`, or either way.
enum class Notation { BARE, MAP, BOTH };

struct StepForm {
    const char* name;
    const char* help;
    Notation notation;                // bare, the value is that of the first field
    std::vector<const char*> any_of;  // at least one of these fields; empty = no such rule
    std::vector<Field> fields;
    Action (*make)(const Values&);
};

const std::vector<StepForm>& step_forms();

// The fields of the file itself; at least one of `steps` and `duration` has to be there.
const std::vector<Field>& file_fields();

}  // namespace sim
