#include "sim/debug/gdb_commands.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "sim/debug/gdb_packet.h"

namespace sim {

namespace {

const char* const OK = "OK";
const char* const ERROR = "E01";
constexpr std::size_t MOST_BYTES = GDB_PACKET_BYTES / 2 - 16;  // bytes of memory per answer

bool begins(std::string_view text, std::string_view with) {
    return text.substr(0, with.size()) == with;
}

// ---- Registers ----------------------------------------------------------------------------------

std::string register_hex(GdbTarget& target, unsigned number) {
    const std::uint64_t value = target.reg(number);  // the wire and the host are little-endian
    return to_hex(&value, target.registers().all[number].bytes());
}

std::uint64_t value_of(std::string_view bytes) {
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data(), bytes.size());
    return value;
}

std::string all_registers(GdbTarget& target) {
    std::string text;
    for (unsigned n = 0; n < target.registers().all.size(); ++n) text += register_hex(target, n);
    return text;
}

// Those that cannot have their value keep their own.
std::string set_all_registers(GdbTarget& target, std::string_view digits) {
    const GdbRegisters& registers = target.registers();
    const auto bytes = from_hex(digits);
    if (!bytes || bytes->size() != registers.bytes()) return ERROR;
    std::vector<std::uint64_t> values;
    std::size_t at = 0;
    for (const GdbRegister& one : registers.all) {
        values.push_back(value_of(std::string_view{*bytes}.substr(at, one.bytes())));
        at += one.bytes();
    }
    target.set_reg(registers.first, values[registers.first]);
    for (unsigned n = 0; n < values.size(); ++n)
        if (n != registers.first) target.set_reg(n, values[n]);
    return OK;
}

std::string one_register(GdbTarget& target, GdbFields fields) {
    const auto number = fields.word();
    if (!number || !fields.rest().empty() || *number >= target.registers().all.size()) return ERROR;
    return register_hex(target, *number);
}

std::string set_one_register(GdbTarget& target, GdbFields fields) {
    const auto& all = target.registers().all;
    const auto number = fields.word();
    if (!number || *number >= all.size() || !fields.skip("=")) return ERROR;
    const auto bytes = from_hex(fields.rest());
    if (!bytes || bytes->size() != all[*number].bytes()) return ERROR;
    return target.set_reg(*number, value_of(*bytes)) ? OK : ERROR;
}

std::string target_description(const GdbRegisters& registers) {
    std::string xml = fmt::format(
        "<?xml version=\"1.0\"?><!DOCTYPE target SYSTEM \"gdb-target.dtd\"><target>"
        "<architecture>{}</architecture>",
        registers.architecture);
    if (*registers.system) xml += fmt::format("<osabi>{}</osabi>", registers.system);
    std::string_view feature;
    for (const GdbRegister& one : registers.all) {
        if (one.feature != feature)
            xml += fmt::format("{}<feature name=\"{}\">", feature.empty() ? "" : "</feature>",
                               one.feature);
        feature = one.feature;
        xml += fmt::format("<reg name=\"{}\" bitsize=\"{}\" type=\"{}\"/>", one.name, one.bits,
                           one.type);
    }
    return xml + "</feature></target>";
}

std::string part_of(const std::string& xml, GdbFields fields) {
    const auto offset = fields.word();
    if (!offset || !fields.skip(",")) return ERROR;
    const auto length = fields.word();
    if (!length) return ERROR;
    if (*offset > xml.size()) return ERROR;
    const std::string part = xml.substr(*offset, std::min<std::size_t>(*length, MOST_BYTES));
    return (*offset + part.size() < xml.size() ? "m" : "l") + part;
}

// ---- Memory -------------------------------------------------------------------------------------

std::string read_memory(GdbTarget& target, GdbFields fields) {
    const auto address = fields.word();
    if (!address || !fields.skip(",")) return ERROR;
    const auto length = fields.number();
    if (!length || !fields.rest().empty()) return ERROR;
    std::vector<std::uint8_t> bytes(std::min<std::uint64_t>(*length, MOST_BYTES));
    const std::size_t count = target.read(*address, bytes.data(), bytes.size());
    if (count == 0 && *length > 0) return ERROR;
    return to_hex(bytes.data(), count);
}

std::string write_memory(GdbTarget& target, GdbFields fields, bool binary) {
    const auto address = fields.word();
    if (!address || !fields.skip(",")) return ERROR;
    const auto length = fields.number();
    if (!length || !fields.skip(":")) return ERROR;
    const auto bytes = binary ? std::string{fields.rest()} : from_hex(fields.rest());
    if (!bytes || bytes->size() != *length) return ERROR;
    return target.write(*address, bytes->data(), bytes->size()) == bytes->size() ? OK : ERROR;
}

std::string change_point(GdbTarget& target, GdbFields fields, bool insert) {
    const auto type = fields.word();
    if (!type || !fields.skip(",")) return ERROR;
    if (*type > 4) return "";
    const auto address = fields.word();
    if (!address || !fields.skip(",")) return ERROR;
    const auto bytes = fields.word();
    if (!bytes) return ERROR;
    const GdbPoint::Kind kinds[] = {GdbPoint::BREAK, GdbPoint::BREAK, GdbPoint::WRITE,
                                    GdbPoint::READ, GdbPoint::ACCESS};
    const GdbPoint point{kinds[*type], *address, *bytes};
    if (point.kind != GdbPoint::BREAK && point.bytes == 0) return ERROR;
    if (insert)
        target.insert(point);
    else
        target.remove(point);
    return OK;
}

// ---- Threads ------------------------------------------------------------------------------------

// "-1", all, and "0", any, are 0.
std::optional<std::uint32_t> thread_id(std::string_view text) {
    if (text == "-1") return 0;
    GdbFields fields{text};
    const auto number = fields.word();
    return fields.rest().empty() ? number : std::nullopt;
}

bool is_thread(GdbTarget& target, std::uint32_t number) {
    const auto all = target.threads();
    return std::any_of(all.begin(), all.end(),
                       [&](const GdbThread& thread) { return thread.number == number; });
}

// A thread that is there, or 0.
std::optional<std::uint32_t> valid_thread(GdbTarget& target, std::string_view text) {
    const auto number = thread_id(text);
    return number && (*number == 0 || is_thread(target, *number)) ? number : std::nullopt;
}

// "g3", "c-1".
std::string choose_thread(GdbTarget& target, std::string_view what) {
    if (!begins(what, "g") && !begins(what, "c")) return ERROR;
    const auto number = valid_thread(target, what.substr(1));
    if (!number) return ERROR;
    if (what[0] == 'g') target.choose_thread(*number);
    return OK;
}

std::string thread_numbers(GdbTarget& target) {
    std::string text;
    for (const GdbThread& thread : target.threads())
        text += fmt::format("{}{:x}", text.empty() ? "m" : ",", thread.number);
    return text;
}

// For XML.  What is not ASCII becomes '?': GDB refuses a whole list that is no UTF-8.
std::string escaped(const std::string& text) {
    std::string xml;
    for (const char c : text) {
        if (c == '&' || c == '<' || c == '"')
            xml += fmt::format("&#{};", static_cast<int>(c));
        else
            xml += c >= ' ' && c <= '~' ? c : '?';
    }
    return xml;
}

std::string thread_list(GdbTarget& target) {
    std::string xml = "<?xml version=\"1.0\"?><threads>";
    for (const GdbThread& thread : target.threads()) {
        xml += fmt::format("<thread id=\"{:x}\"", thread.number);
        if (!thread.name.empty()) xml += fmt::format(" name=\"{}\"", escaped(thread.name));
        xml += ">" + escaped(thread.state) + "</thread>";
    }
    return xml + "</threads>";
}

// ---- Running ------------------------------------------------------------------------------------

// "c", "s" with an address, "C", "S" with a signal and an address: "c8000", "C05;8000".
GdbAnswer resume(GdbTarget& target, char command, GdbFields fields) {
    const GdbNext next = command == 's' || command == 'S' ? GdbNext::STEP : GdbNext::CONTINUE;
    if (command == 'C' || command == 'S') {
        if (!fields.number()) return {ERROR};
        if (!fields.rest().empty() && !fields.skip(";")) return {ERROR};
    }
    if (!fields.rest().empty()) {
        const auto address = fields.word();
        if (!address) return {ERROR};
        target.set_reg(target.registers().pc, *address);
    }
    return {"", next};
}

// "vCont;s:3;c": of the actions for a thread the first one is valid.
GdbAnswer resume_threads(GdbTarget& target, std::string_view actions) {
    if (actions.empty()) return {ERROR};
    GdbAnswer answer{"", GdbNext::CONTINUE};
    bool all_have_one = false;
    while (!actions.empty()) {
        const std::string_view action = actions.substr(0, actions.find(';'));
        actions.remove_prefix(std::min(actions.size(), action.size() + 1));
        const char kind = action.empty() ? '\0' : action[0];
        const bool steps = kind == 's' || kind == 'S';
        if (!steps && kind != 'c' && kind != 'C') return {ERROR};
        GdbFields fields{action.substr(1)};
        if ((kind == 'C' || kind == 'S') && !fields.number()) return {ERROR};
        std::optional<std::uint32_t> thread = 0;
        if (!fields.rest().empty())
            thread = fields.skip(":") ? valid_thread(target, fields.rest()) : std::nullopt;
        if (!thread) return {ERROR};
        if (steps && !all_have_one && answer.next == GdbNext::CONTINUE)
            answer = {"", GdbNext::STEP, *thread};
        all_have_one |= *thread == 0;
    }
    return answer;
}

// ---- Queries ------------------------------------------------------------------------------------

std::string query(GdbTarget& target, std::string_view packet) {
    if (begins(packet, "qSupported"))
        return fmt::format(
            "PacketSize={:x};qXfer:features:read+;qXfer:threads:read+;vContSupported+;swbreak+;"
            "QStartNoAckMode+",
            GDB_PACKET_BYTES);
    constexpr std::string_view FEATURES = "qXfer:features:read:target.xml:",
                               THREADS = "qXfer:threads:read::";
    if (begins(packet, FEATURES))
        return part_of(target_description(target.registers()),
                       GdbFields{packet.substr(FEATURES.size())});
    if (begins(packet, "qXfer:features:read:")) return "E00";
    if (begins(packet, THREADS))
        return part_of(thread_list(target), GdbFields{packet.substr(THREADS.size())});
    if (packet == "qAttached" || begins(packet, "qAttached:")) return "1";
    if (packet == "qC") return fmt::format("QC{:x}", target.chosen_thread());
    if (packet == "qfThreadInfo") return thread_numbers(target);
    if (packet == "qsThreadInfo") return "l";
    if (packet == "qOffsets" && target.displacement() != 0)
        return fmt::format("TextSeg={:x}", target.displacement());
    if (begins(packet, "qRcmd,")) {
        const auto command = from_hex(packet.substr(6));
        if (!command) return ERROR;
        const std::string text = target.monitor(*command);
        return to_hex(text.data(), text.size());
    }
    return "";
}

}  // namespace

GdbAnswer gdb_answer(GdbTarget& target, std::string_view packet) {
    if (packet.empty()) return {};
    const GdbFields fields{packet.substr(1)};
    switch (packet[0]) {
        case '?': return {target.stop_reply()};
        case 'g': return {all_registers(target)};
        case 'G': return {set_all_registers(target, fields.rest())};
        case 'p': return {one_register(target, fields)};
        case 'P': return {set_one_register(target, fields)};
        case 'm': return {read_memory(target, fields)};
        case 'M': return {write_memory(target, fields, false)};
        case 'X': return {write_memory(target, fields, true)};
        case 'Z': return {change_point(target, fields, true)};
        case 'z': return {change_point(target, fields, false)};
        case 'c':
        case 'C':
        case 's':
        case 'S': return resume(target, packet[0], fields);
        case 'H': return {choose_thread(target, packet.substr(1))};
        case 'T': {
            const auto number = thread_id(packet.substr(1));
            return {number && is_thread(target, *number) ? OK : ERROR};
        }
        case 'D': return {OK, GdbNext::DETACH};
        case 'k': return {"", GdbNext::KILL};
        case 'q': return {query(target, packet)};
        default: break;
    }
    if (packet == "QStartNoAckMode") return {OK};
    if (packet == "vCont?") return {"vCont;c;C;s;S"};
    if (begins(packet, "vCont;")) return resume_threads(target, packet.substr(6));
    if (begins(packet, "vKill")) return {OK, GdbNext::KILL};
    return {};
}

}  // namespace sim
