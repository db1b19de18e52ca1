#include "sim/vhdl/vhdl_library.h"

#include <cctype>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/verilog/project_error.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

// The type of vectors of words, in the libraries that have one.
std::string words_of(const std::string& library) {
    return library == "lpm" ? "std_logic_2d" : library == "altera_mf" ? "altera_mf_logic_2d" : "";
}

std::string array_of(const std::string& library) {
    const std::string type = words_of(library);
    if (type.empty()) return type;
    return fmt::format("    type {} is array (natural range <>, natural range <>) of std_logic;\n",
                       type);
}

// Of synthesis, which say nothing here.
std::string attributes() {
    static const std::pair<const char*, const char*> ALL[] = {
        {"altera_attribute", "string"}, {"chip_pin", "string"},        {"direct_enable", "boolean"},
        {"dont_merge", "boolean"},      {"dont_replicate", "boolean"}, {"dont_retime", "boolean"},
        {"enum_encoding", "string"},    {"keep", "boolean"},           {"maxfan", "natural"},
        {"multstyle", "string"},        {"noprune", "boolean"},        {"preserve", "boolean"},
        {"ram_init_file", "string"},    {"ramstyle", "string"},        {"romstyle", "string"},
        {"syn_encoding", "string"},     {"useioff", "boolean"}};
    std::string text = "package altera_syn_attributes is\n";
    for (const auto& [name, type] : ALL)
        text += fmt::format("    attribute {} : {};\n", name, type);
    return text + "end package;\n";
}

// Of a component: both lists as VHDL has them.
struct Component {
    std::string name;
    std::vector<std::string> generics, ports;
};

std::string library_of(const std::string& model) {
    const auto begins = [&model](const char* with) { return model.rfind(with, 0) == 0; };
    if (begins("lpm_")) return "lpm";
    if (begins("cyclonev_")) return "cyclonev";
    if (begins("altera_pll") || begins("altera_syncram") || begins("altera_mult_add"))
        return "altera_lnsim";
    if (begins("parallel_add")) return "altera_mf";
    if (begins("alt_")) return "altera";  // buffers
    return begins("alt") || begins("scfifo") || begins("dcfifo") || begins("sld_") ? "altera_mf"
                                                                                   : "altera";
}

// With the files that the header includes in the place of their names.
std::string whole_text(const fs::path& model) {
    static const std::string INCLUDE = "`include \"";
    std::string text = text_of(model);
    const std::size_t at = text.find(INCLUDE);
    if (at == std::string::npos || at > text.find("\n);")) return text;
    const std::size_t name = at + INCLUDE.size(), end = text.find('"', name);
    return text.replace(at, end + 1 - at,
                        text_of(model.parent_path() / text.substr(name, end - name)));
}

class ModelReader {
public:
    ModelReader(const std::string& text, const std::string& library, const OpenInputs& ones)
        : all_{tokens_of(text).all}, library_{library}, ones_{ones} {}

    Component run() {
        while (!is("module")) ++at_;
        component_.name = all_.at(++at_).text;
        if (all_.at(++at_).is("#")) parameters();
        for (++at_; !all_[at_ - 1].is(")");) port();
        return component_;
    }

private:
    bool is(std::string_view text) const { return all_.at(at_).is(text); }

    // #( parameter width = 1, WIDTH = width, ... ) up to the next parenthesis.
    void parameters() {
        for (at_ += 2; !is("("); ++at_) {
            const std::string_view name = all_.at(at_).text;
            if (!all_.at(at_ + 1).is("=") || !std::islower(static_cast<unsigned char>(name[0])))
                continue;  // the twin in upper case
            std::string value{all_.at(at_ + 2).text};
            if (value == "-") value += all_[at_ + 3].text;
            const char* type = value[0] == '"' ? "string" : value[0] == '-' ? "integer" : "natural";
            component_.generics.push_back(fmt::format("{} : {} := {}", name, type, value));
        }
    }

    // From "input" to after the comma or the parenthesis.
    void port() {
        if (is("input") || is("output") || is("inout")) {
            direction_ = all_.at(at_).text;
            range_.clear();
            at_ += 2;
            if (is("["))
                for (++at_; !is("]"); ++at_) {
                    if (is("?")) {  // (WIDTH ? WIDTH : 1)-1 is WIDTH-1, of no bits in VHDL
                        range_.erase(0, 1);
                        while (!is(")")) ++at_;
                        continue;
                    }
                    range_ += is(":") ? " downto " : std::string{all_.at(at_).text};
                }
            at_ += !range_.empty();
        }
        const std::string name{all_.at(at_).text};
        const bool word = name == "in" || name == "out";
        const char* direction = direction_ == "input"    ? "in"
                                : direction_ == "output" ? "out"
                                                         : "inout";
        component_.ports.push_back(fmt::format("{}{} : {} {}{}", word ? "a_" : "", name, direction,
                                               type(), direction_ == "input" ? value(name) : ""));
        at_ += 2;
    }

    // In lpm, and with SIZE in altera_mf, a product of widths is an array of two dimensions:
    // LPM_SIZE*LPM_WIDTH-1 downto 0.
    std::string type() const {
        const std::size_t product = range_.find('*');
        if (range_.empty()) return "std_logic";
        if (product == std::string::npos ||
            (library_ != "lpm" && range_.substr(0, product) != "SIZE"))
            return fmt::format("std_logic_vector({})", range_);
        return fmt::format("{}({}-1 downto 0, {})", words_of(library_), range_.substr(0, product),
                           range_.substr(product + 1));
    }
    std::string value(const std::string& port) const {
        bool one = false;
        const auto [begin, end] = ones_.equal_range(component_.name);
        for (auto input = begin; input != end; ++input) one = one || input->second == port;
        const char bit = one ? '1' : '0';
        if (range_.empty()) return fmt::format(" := '{}'", bit);
        if (type().find("_2d(") != std::string::npos) return {};
        return fmt::format(" := (others => '{}')", bit);
    }

    const std::vector<Token> all_;
    const std::string& library_;
    const OpenInputs& ones_;
    std::size_t at_ = 0;
    std::string direction_, range_;
    Component component_;
};

std::string list_of(const char* word, const std::vector<std::string>& members) {
    std::string text;
    for (const std::string& member : members)
        text += fmt::format("{}\n            {}", text.empty() ? "" : ";", member);
    return text.empty() ? text : fmt::format("        {} ({});\n", word, text);
}

}  // namespace

std::map<std::string, std::string> vhdl_libraries(const fs::path& models, const OpenInputs& ones) {
    std::map<std::string, fs::path> files;
    for (const auto& entry : fs::directory_iterator{models}) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".v" && name.rfind("de1sim_", 0) != 0)
            files.emplace(name, entry.path());
    }
    std::map<std::string, std::string> components;  // by the library
    for (const auto& [name, file] : files) {
        const std::string library = library_of(name), text = whole_text(file);
        const Component component = ModelReader{text, library, ones}.run();
        components[library] +=
            fmt::format("    component {}\n{}{}    end component;\n", name,
                        list_of("generic", component.generics), list_of("port", component.ports));
    }
    static const std::pair<const char*, const char*> PACKAGES[] = {
        {"altera", "altera_primitives_components"},  {"altera", "maxplus2"},
        {"altera_lnsim", "altera_lnsim_components"}, {"altera_mf", "altera_mf_components"},
        {"cyclonev", "cyclonev_components"},         {"lpm", "lpm_components"}};
    std::map<std::string, std::string> libraries{{"altera", attributes()}};
    for (const auto& [library, package] : PACKAGES)
        libraries[library] += fmt::format(
            "library ieee;\nuse ieee.std_logic_1164.all;\n\npackage {} is\n{}{}end package;\n",
            package, array_of(library), components[library]);
    return libraries;
}

}  // namespace sim::project
