#include "sim/verilog/top_parameters.h"

#include <iterator>
#include <regex>
#include <sstream>

#include <fmt/format.h>

#include "sim/text/lower.h"

namespace sim::project {

std::string verilog_value(const std::string& value) {
    static const std::regex NUMBER{
        R"(-?[0-9][0-9_]*(\.[0-9]+)?|[0-9]*'s?[bodhBODH][0-9a-fA-FxXzZ_]+)"};
    if (std::regex_match(value, NUMBER)) return value;
    if (lower(value) == "true") return "1";
    if (lower(value) == "false") return "0";
    std::string text;
    for (const char c : value) text += (c == '"' || c == '\\' ? "\\" : "") + std::string{c};
    return '"' + text + '"';
}

std::vector<std::string> verilator_options(const TopParameters& parameters) {
    std::vector<std::string> words;
    for (const auto& [name, parameter] : parameters)
        words.push_back("-G" + name + "=" + parameter.value);
    return words;
}

std::vector<std::string> unknown_parameters(const std::string& output) {
    static const std::string SENTENCE =
        "Parameters from the command line were not found in the design:";
    const std::size_t at = output.find(SENTENCE);
    if (at == std::string::npos) return {};
    std::istringstream names{output.substr(at + SENTENCE.size())};
    return {std::istream_iterator<std::string>{names}, {}};
}

std::string instance_text(const TopParameters& parameters) {
    std::string text;
    for (const auto& [name, parameter] : parameters)
        text += fmt::format("{}.{} ({})", text.empty() ? " #(" : ", ", name, parameter.value);
    return text.empty() ? "" : text + ")";
}

}  // namespace sim::project
