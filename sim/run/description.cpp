#include "sim/run/description.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sim {

namespace {

using nlohmann::json;

// A path may have any bytes, and JSON has characters: each byte is the character of its number.
std::string characters_of(const std::string& bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            text += c;
        } else {
            text += static_cast<char>(0xc0 | byte >> 6);
            text += static_cast<char>(0x80 | (byte & 0x3f));
        }
    }
    return text;
}

std::string bytes_of(const std::string& text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x80)
            bytes += text[i];
        else if ((byte & 0xfc) == 0xc0 && i + 1 < text.size())
            bytes += static_cast<char>((byte & 3) << 6 | (text[++i] & 0x3f));
        else
            throw std::runtime_error{"a character that is no byte"};
    }
    return bytes;
}

template <class Fields, class Description>
void fields(Fields& field, Description& d);

// Writes the fields of a structure into an object of JSON.
class Writer {
public:
    template <class Value>
    void operator()(const char* name, const Value& value) {
        put(all[name], value);
    }

    json all = json::object();

private:
    template <class Value>
    static void put(json& to, const std::optional<Value>& value) {
        if (value)
            put(to, *value);
        else
            to = nullptr;
    }
    static void put(json& to, const std::string& value) { to = characters_of(value); }
    static void put(json& to, const std::filesystem::path& value) { put(to, value.string()); }
    static void put(json& to, const std::vector<std::string>& values) {
        to = json::array();
        for (const std::string& value : values) put(to.emplace_back(), value);
    }
    static void put(json& to, const SimTime& value) { to = value.ps; }
    static void put(json& to, const FrameChoice& value) { to = value.text(); }
    template <class Value>
    static void put(json& to, const Value& value) {
        if constexpr (std::is_class_v<Value>) {
            Writer inner;
            fields(inner, value);
            to = std::move(inner.all);
        } else {
            to = value;
        }
    }
};

// Reads them.
class Reader {
public:
    explicit Reader(const json& all) : all_{all} {}

    template <class Value>
    void operator()(const char* name, Value& value) {
        get(all_.at(name), value);
    }

private:
    template <class Value>
    static void get(const json& from, std::optional<Value>& value) {
        if (from.is_null())
            value.reset();
        else
            get(from, value.emplace());
    }
    static void get(const json& from, std::string& value) {
        value = bytes_of(from.get<std::string>());
    }
    static void get(const json& from, std::filesystem::path& value) {
        value = bytes_of(from.get<std::string>());
    }
    static void get(const json& from, std::vector<std::string>& values) {
        values.clear();
        for (const json& value : from) get(value, values.emplace_back());
    }
    static void get(const json& from, SimTime& value) { from.get_to(value.ps); }
    static void get(const json& from, FrameChoice& value) {
        const auto choice = FrameChoice::parse(from.get<std::string>());
        if (!choice) throw std::runtime_error{"no choice of frames"};
        value = *choice;
    }
    template <class Value>
    static void get(const json& from, Value& value) {
        if constexpr (std::is_class_v<Value>) {
            Reader inner{from};
            fields(inner, value);
        } else {
            from.get_to(value);
        }
    }

    const json& all_;
};

// Each structure's fields, for both directions.
template <class Fields, class Description>
void fields(Fields& field, Description& d) {
    using Type = std::remove_const_t<Description>;
    if constexpr (std::is_same_v<Type, ProjectOptions>) {
        field("place", d.place);
        field("top", d.top);
        field("macros", d.macros);
        field("build_limit_s", d.build_limit_s);
    } else if constexpr (std::is_same_v<Type, ChipDescription>) {
        field("project", d.project);
        field("bridged_memory", d.bridged_memory);
        field("audio_rate", d.audio_rate);
        field("strict_vga", d.strict_vga);
    } else if constexpr (std::is_same_v<Type, ProgramDescription>) {
        field("cpu", d.cpu);
        field("elf", d.elf);
        field("cpi", d.cpi);
        field("shortcuts", d.shortcuts);
        field("system", d.system);
        field("linux_root", d.linux_root);
        field("arguments", d.arguments);
        field("input", d.input);
        field("arm_options", d.arm_options);
    } else if constexpr (std::is_same_v<Type, TraceDescription>) {
        field("file", d.file);
        field("from", d.from);
        field("to", d.to);
    } else if constexpr (std::is_same_v<Type, RunOutputs>) {
        field("out", d.out);
        field("frames", d.frames);
        field("html", d.html);
        field("video", d.video);
        field("profile", d.profile);
        field("trace", d.trace);
        field("trace_failure", d.trace_failure);
        field("gdb", d.gdb);
        field("live_socket", d.live_socket);
        field("update_goldens", d.update_goldens);
        field("quiet", d.quiet);
    } else {
        field("scenario", d.scenario);
        field("scenario_text", d.scenario_text);
        field("chip", d.chip);
        field("program", d.program);
        field("outputs", d.outputs);
        field("duration", d.duration);
        field("seed", d.seed);
        field("command", d.command);
    }
}

}  // namespace

std::optional<FrameChoice> FrameChoice::parse(const std::string& text) {
    if (text == "new") return FrameChoice{Which::NEW, 1};
    if (text == "all") return FrameChoice{Which::ALL, 1};
    if (text == "last") return FrameChoice{Which::LAST, 1};
    if (text == "none") return FrameChoice{Which::NONE, 1};
    if (text.rfind("every:", 0) != 0) return std::nullopt;
    FrameChoice choice{Which::EVERY, 0};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + 6, end, choice.every);
    if (error != std::errc{} || stop != end || choice.every == 0) return std::nullopt;
    return choice;
}

std::string FrameChoice::text() const {
    switch (which) {
        case Which::NEW: return "new";
        case Which::ALL: return "all";
        case Which::LAST: return "last";
        case Which::NONE: return "none";
        case Which::EVERY: break;
    }
    return "every:" + std::to_string(every);
}

std::string to_json(const RunDescription& description) {
    Writer writer;
    fields(writer, description);
    return writer.all.dump() + "\n";
}

RunDescription description_from(const std::string& text, const std::string& name) {
    RunDescription description;
    try {
        const json all = json::parse(text);
        Reader reader{all};
        fields(reader, description);
    } catch (const std::exception& error) {
        throw std::runtime_error{
            fmt::format("{}: expected the description of a run as this version writes it: {}", name,
                        error.what())};
    }
    return description;
}

DescriptionFile::DescriptionFile(const RunDescription& description)
    : descriptor_{memfd_create("de1sim-run", 0)} {
    if (descriptor_ < 0)
        throw std::runtime_error{std::string{"no memory for the description of a run: "} +
                                 std::strerror(errno)};
    const std::string text = to_json(description);
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t written = write(descriptor_, text.data() + at, text.size() - at);
        if (written < 0) {
            const int reason = errno;
            close(descriptor_);
            throw std::runtime_error{std::string{"the description of a run: "} +
                                     std::strerror(reason)};
        }
        at += static_cast<std::size_t>(written);
    }
}

DescriptionFile::~DescriptionFile() { close(descriptor_); }

std::vector<std::string> DescriptionFile::command() const {
    return {std::filesystem::read_symlink("/proc/self/exe").string(), "run", "--description",
            fmt::format("/proc/self/fd/{}", descriptor_)};
}

}  // namespace sim
