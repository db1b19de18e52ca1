// gen_schema.cpp - prints scenario.schema.json from the forms of the steps
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim/scenario/part_table.h"
#include "sim/scenario/step_table.h"

namespace {

using Json = nlohmann::ordered_json;

template <class AForm>
Json items_schema(const std::vector<AForm>& forms);

// Of types with long lists of words, so that the lists are not repeated at each field.
Json definitions = Json::object();

Json field_schema(const sim::Field& field) {
    if (field.type.schema.empty()) {
        Json list = {{"description", field.help}, {"type", "array"}, {"minItems", 1}};
        list["items"] = std::string{field.name} == "parts" ? items_schema(sim::part_forms())
                                                           : items_schema(sim::step_forms());
        return list;
    }
    Json one = Json::parse(field.type.schema);
    if (one.contains("enum") && one["enum"].size() > 20) {
        definitions[field.name] = std::move(one);
        one = {{"$ref", std::string{"#/definitions/"} + field.name}};
    }
    Json out = {{"description", field.help}};
    if (!field.type.list_of.empty()) {
        Json list = {{"type", "array"}, {"minItems", 1}};
        if (!field.type.several) list["uniqueItems"] = true;
        if (field.type.at_most) list["maxItems"] = field.type.at_most;
        list["items"] = one;
        out["anyOf"] = {one, list};
    } else {
        out.update(one);
    }
    if (*field.preset) {
        const bool is_text = one.value("type", "") == "string";
        out["default"] = is_text ? Json(field.preset) : Json::parse(field.preset);
    }
    return out;
}

Json object(const std::vector<sim::Field>& fields) {
    Json out = {{"type", "object"}, {"additionalProperties", false}};
    Json required = Json::array();
    for (const auto& field : fields) {
        out["properties"][field.name] = field_schema(field);
        if (field.need == sim::Need::REQUIRED) required.push_back(field.name);
    }
    if (!required.empty()) out["required"] = required;
    return out;
}

Json any_of(const std::vector<const char*>& names) {
    Json out = Json::array();
    for (const char* name : names) out.push_back({{"required", Json::array({name})}});
    return out;
}

template <class AForm>
Json item_schema(const AForm& form) {
    Json bare = field_schema(form.fields[0]);
    bare.erase("description");
    Json map = object(form.fields);
    if (!form.any_of.empty()) map[form.only_one ? "oneOf" : "anyOf"] = any_of(form.any_of);
    Json out = {{"description", form.help}};
    if (form.notation == sim::Notation::BOTH)
        out["anyOf"] = {bare, map};
    else
        out.update(form.notation == sim::Notation::BARE ? bare : map);
    return out;
}

template <class AForm>
Json items_schema(const std::vector<AForm>& forms) {
    Json out = {{"type", "object"},
                {"additionalProperties", false},
                {"minProperties", 1},
                {"maxProperties", 1}};
    for (const auto& form : forms) out["properties"][form.name] = item_schema(form);
    return out;
}

}  // namespace

int main() {
    Json schema = {
        {"$schema", "http://json-schema.org/draft-07/schema#"},
        {"title", "Scenario for de1sim"},
        {"$comment", "Generated from the forms of the steps by the target schema_files."}};
    schema.update(object(sim::file_fields()));
    if (!definitions.empty()) schema["definitions"] = definitions;
    schema["anyOf"] = any_of({"steps", "duration"});
    std::cout << schema.dump(2) << "\n";
}
