#include "sim/run/description.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

// Null for a value that is not there.
template <class Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
    static void to_json(json& to, const std::optional<Value>& value) {
        to = value ? json(*value) : json();
    }
    static void from_json(const json& from, std::optional<Value>& value) {
        value = from.is_null() ? std::nullopt : std::optional{from.get<Value>()};
    }
};

namespace sim {

using nlohmann::json;

static void to_json(json& to, const SimTime& time) { to = time.ps; }
static void from_json(const json& from, SimTime& time) { from.get_to(time.ps); }

static void to_json(json& to, const FrameChoice& choice) { to = choice.text(); }
static void from_json(const json& from, FrameChoice& choice) {
    const auto parsed = FrameChoice::parse(from.get<std::string>());
    if (!parsed) throw std::runtime_error{"no choice of frames"};
    choice = *parsed;
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProjectOptions, place, top, board, macros, build_limit_s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChipDescription, project, bridged_memory, audio_rate, strict_vga,
                                   ddr3_mb_per_s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProgramDescription, cpu, elf, cpi, shortcuts, system, linux_root,
                                   arguments, modules, input, network, arm_options)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TraceDescription, file, from, to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunOutputs, out, frames, html, video, profile, trace,
                                   trace_failure, gdb, live_socket, update_goldens, quiet)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunDescription, scenario, scenario_text, chip, program, outputs,
                                   duration, seed, command)

namespace {

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

void change_strings(json& value, std::string (*change)(const std::string&)) {
    if (value.is_string())
        value = change(value.get_ref<const std::string&>());
    else if (value.is_structured())
        for (json& inner : value) change_strings(inner, change);
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
    json all = description;
    change_strings(all, characters_of);
    return all.dump() + "\n";
}

RunDescription description_from(const std::string& text, const std::string& name) {
    try {
        json all = json::parse(text);
        change_strings(all, bytes_of);
        return all.get<RunDescription>();
    } catch (const std::exception& error) {
        throw std::runtime_error{
            fmt::format("{}: expected the description of a run as this version writes it: {}", name,
                        error.what())};
    }
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
