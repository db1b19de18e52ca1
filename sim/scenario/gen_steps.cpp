// gen_steps.cpp - prints STEPS.md from the forms of the steps
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "sim/scenario/part_table.h"
#include "sim/scenario/step_table.h"

namespace {

// Text in a cell of a table.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != text.npos; at += 2) text.insert(at, "\\");
    return text;
}

std::string value_of(const sim::Field& field) {
    return cell(field.type.expected) + (field.type.list_of.empty() ? "" : ", or a list");
}

void print_fields(const std::vector<sim::Field>& fields) {
    std::cout << "| Field | Value | Default | What |\n|---|---|---|---|\n";
    for (const sim::Field& field : fields) {
        const std::string preset = field.need == sim::Need::REQUIRED ? "has to be there"
                                   : *field.preset                   ? field.preset
                                                                     : "";
        std::cout << fmt::format("| `{}` | {} | {} | {} |\n", field.name, value_of(field), preset,
                                 cell(field.help));
    }
}

// `press-key: ...` or `press-key: {key: ..., for: ...}`
template <class AForm>
std::string notation(const AForm& form) {
    std::string map;
    for (const sim::Field& field : form.fields)
        map += fmt::format("{}{}: ...", map.empty() ? "" : ", ", field.name);
    const std::string as_map = fmt::format("`{}: {{{}}}`", form.name, map);
    const std::string bare =
        fmt::format("`{}: ...` with the {} alone", form.name, form.fields[0].name);
    switch (form.notation) {
        case sim::Notation::BARE: return bare;
        case sim::Notation::MAP: return as_map;
        default: return bare + ", or " + as_map;
    }
}

template <class AForm>
void print_form(const char* level, const AForm& form) {
    std::cout << fmt::format("\n{} {}\n\n{}\n\n{}\n\n", level, form.name, form.help,
                             notation(form));
    print_fields(form.fields);
}

}  // namespace

int main() {
    std::cout << "# Scenario files\n\nPrinted from the forms of the steps by `make regmap`.\n\n"
                 "## The file\n\n";
    print_fields(sim::file_fields());
    std::cout << "\n## Parts\n\nItems of the list `parts`. In a map within braces a pin stands in "
                 "quotes: `{name: a, pin: \"GPIO_0[3]\"}`.\nThe Arduino header of a DE10-Lite or "
                 "DE10-Nano has ARDUINO_IO[0] to [15].\n";
    for (const sim::PartForm& form : sim::part_forms()) print_form("###", form);
    for (const sim::StepForm& form : sim::step_forms()) print_form("##", form);
}
