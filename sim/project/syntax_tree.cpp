#include "sim/project/syntax_tree.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/project/settings.h"
#include "sim/text/lower.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

using json = nlohmann::ordered_json;  // operands are in their order

json json_of(const fs::path& file) {
    std::ifstream in{file};
    json text = json::parse(in, nullptr, false);
    if (text.is_discarded())
        throw ProjectError{fmt::format("{}: Verilator has not written it whole", file.string())};
    return text;
}

std::string text(const json& node, const char* name) {
    const auto found = node.find(name);
    return found != node.end() && found->is_string() ? found->get<std::string>() : "";
}

void set(pugi::xml_node to, const char* name, const std::string& value) {
    if (!value.empty()) to.append_attribute(name).set_value(value.c_str());
}

class Converter {
public:
    Converter(const json& netlist, pugi::xml_node root) {
        note_addresses(netlist);
        pugi::xml_node to = root.append_child("netlist");
        for (const json& module : netlist.at("modulesp")) add(module, to);
        set(to.first_child(), "topModule", "1");
        pugi::xml_node types = to.append_child("typetable");
        for (const json& node : netlist.at("miscsp"))
            if (node.at("type") == "TYPETABLE")
                for (const json& type : node.at("typesp")) add(type, types);
    }

private:
    // Modules and variables, to which others refer; and the types' keywords.
    void note_addresses(const json& node) {
        const std::string type = text(node, "type"), address = text(node, "addr");
        if (type == "MODULE" || type == "VAR" || type == "BASICDTYPE") nodes_[address] = &node;
        for (const json& field : node)
            if (field.is_array())
                for (const json& below : field)
                    if (below.is_object()) note_addresses(below);
    }
    const json* at(const std::string& address) const {
        const auto found = nodes_.find(address);
        return found == nodes_.end() ? nullptr : found->second;
    }

    void add_all(const json& fields, pugi::xml_node to) {
        for (const json& below : fields)
            if (below.is_object()) add(below, to);
    }
    void add_below(const json& node, pugi::xml_node to) {
        for (const json& field : node)
            if (field.is_array()) add_all(field, to);
    }
    static const json& field(const json& node, const char* name) {
        static const json NONE = json::array();
        const auto found = node.find(name);
        return found == node.end() ? NONE : *found;
    }

    void add(const json& node, pugi::xml_node parent) {
        const std::string type = lower(text(node, "type"));
        if (type == "always" && text(node, "keyword") == "cont_assign")
            return add_all(field(node, "stmtsp"), parent);
        pugi::xml_node to = parent.append_child(name_of(type));
        std::string place = text(node, "loc");  // "e,3:8,3:11"
        std::replace(place.begin(), place.end(), ':', ',');
        set(to, "loc", place);
        set(to, "name", text(node, "name"));
        set(to, "origName", text(node, "origName"));
        set(to, "id", text(node, "addr"));
        set(to, "dtype_id", text(node, "dtypep"));
        set(to, "sub_dtype_id", text(node, "refDTypep"));
        set(to, "edgeType", text(node, "edgeType"));
        if (node.value("signed", false)) set(to, "signed", "true");
        if (const std::string range = text(node, "range"); !range.empty()) {  // "7:0"
            set(to, "left", range.substr(0, range.find(':')));
            set(to, "right", range.substr(range.find(':') + 1));
        }
        if (type == "var") return add_variable(node, to);
        if (type == "cell") return add_instance(node, to);
        if (type == "if") return add_if(node, to);
        if (type == "loop" || type == "while") return add_loop(node, to);
        add_below(node, to);
        if (const auto width = node.find("widthConst"); width != node.end())
            set(to.append_child("const"), "name", fmt::format("32'h{:x}", width->get<unsigned>()));
    }

    static const char* name_of(const std::string& type) {
        static const std::map<std::string, const char*> NAMES{{"assignw", "contassign"},
                                                              {"cell", "instance"},
                                                              {"genblock", "begin"},
                                                              {"loop", "while"},
                                                              {"pin", "port"}};
        const auto found = NAMES.find(type);
        return found == NAMES.end() ? type.c_str() : found->second;
    }

    void add_variable(const json& node, pugi::xml_node to) {
        const std::string kind = text(node, "varType");
        if (const std::string direction = text(node, "direction"); direction != "NONE") {
            set(to, "dir", lower(direction));
            if (std::string{to.parent().name()} == "module") {
                int index = 1;
                for (const auto& other : to.parent().children("var"))
                    index += other.attribute("pinIndex") ? 1 : 0;
                to.append_attribute("pinIndex").set_value(index);
            }
        }
        if (const json* type = at(text(node, "dtypep"))) set(to, "vartype", text(*type, "keyword"));
        if (kind == "GPARAM") set(to, "param", "true");
        if (kind == "LPARAM") set(to, "localparam", "true");
        add_below(node, to);
    }

    void add_instance(const json& node, pugi::xml_node to) {
        if (const json* module = at(text(node, "modp"))) set(to, "defName", text(*module, "name"));
        for (const json& pin : field(node, "pinsp")) {
            add(pin, to);
            const json* port = at(text(pin, "modVarp"));
            const std::string direction = port ? lower(text(*port, "direction")) : "";
            set(to.last_child(), "direction",
                direction == "input"    ? "in"
                : direction == "output" ? "out"
                                        : direction);
        }
        add_all(field(node, "rangep"), to);
    }

    void add_if(const json& node, pugi::xml_node to) {
        add_all(field(node, "condp"), to);
        add_all(field(node, "thensp"), to.append_child("begin"));
        if (const json& otherwise = field(node, "elsesp"); !otherwise.empty())
            add_all(otherwise, to.append_child("begin"));
    }

    // Before the condition, the condition, the body, what ends each turn.
    void add_loop(const json& node, pugi::xml_node to) {
        add_all(field(node, "precondsp"), to.append_child("begin"));
        pugi::xml_node condition = to.append_child("begin"), body = to.append_child("begin");
        add_all(field(node, "condp"), condition);
        for (const json& statement : field(node, "stmtsp"))
            if (text(statement, "type") == "LOOPTEST")
                add_all(field(statement, "condp"), condition);
            else
                add(statement, body);
        for (const char* last : {"incsp", "contsp"})
            if (const json& turn = field(node, last); !turn.empty())
                add_all(turn, to.append_child("begin"));
    }

    std::map<std::string, const json*> nodes_;  // by address
};

}  // namespace

std::string tree_meta(const std::string& file) {
    return fs::path{file}.replace_extension(".meta.json").string();
}

pugi::xml_document syntax_tree(const fs::path& file) {
    pugi::xml_document document;
    if (file.extension() == ".xml") {
        const auto result = document.load_file(file.c_str());
        if (!result) throw ProjectError{fmt::format("{}: {}", file.string(), result.description())};
        return document;
    }
    pugi::xml_node root = document.append_child("verilator_xml");
    pugi::xml_node files = root.append_child("files");
    const json meta = json_of(tree_meta(file.string()));
    for (const auto& [id, source] : meta.at("files").items()) {
        pugi::xml_node one = files.append_child("file");
        one.append_attribute("id").set_value(id.c_str());
        one.append_attribute("filename")
            .set_value(source.at("filename").get<std::string>().c_str());
    }
    const json netlist = json_of(file);
    Converter{netlist, root};
    return document;
}

}  // namespace sim::project
