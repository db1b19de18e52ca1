// settings_script.cpp - runs a settings file as the Tcl that it is: settings.h.
#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "sim/project/safe_tcl.h"
#include "sim/project/settings.h"
#include "sim/text/lower.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

using Words = SafeTcl::Words;

constexpr unsigned DEEPEST_SOURCE = 8, MOST_SOURCED = 1'000;

// All values of its name and target, unless it has one itself.
void remove(std::vector<Assignment>& all, const Assignment& which) {
    const auto same = [&](const Assignment& a) {
        return a.name == which.name && a.to == which.to &&
               (which.value.empty() || a.value == which.value);
    };
    all.erase(std::remove_if(all.begin(), all.end(), same), all.end());
}

// Commands of Quartus that say nothing about what is in the chip.
bool is_of_quartus(const std::string& name) {
    static const std::set<std::string> NAMES{"export_assignments",
                                             "load_package",
                                             "package",
                                             "post_message",
                                             "project_close",
                                             "project_new",
                                             "project_open",
                                             "puts",
                                             "set_current_revision",
                                             "set_io_assignment",
                                             "set_power_file_assignment",
                                             "set_user_option"};
    return NAMES.count(name) > 0;
}

class SettingsScript {
public:
    SettingsScript() {
        for (const char* name :
             {"set_global_assignment", "set_location_assignment", "set_instance_assignment",
              "set_parameter", "source", "file", "unknown"})
            tcl_.add(name, [this](const Words& words) { return command(words); });
        tcl_.set("quartus", "version", "18.1");
        tcl_.set("quartus", "nameofexecutable", "quartus_sh");
    }

    Settings run(std::string_view text, const fs::path& file) {
        read(text, file);
        return std::move(settings_);
    }

private:
    // Command by command, so that each has its line.
    void read(std::string_view text, const fs::path& file) {
        const auto before = std::pair{file_, line_};
        // It ends with a "/": public files join it with a name as it is.
        const std::string folder =
            (fs::absolute(file).lexically_normal().parent_path() / "").string();
        const std::string qip_before = std::exchange(folder_, folder);
        tcl_.set("quartus", "qip_path", folder);
        tcl_.set("quartus", "project", file.stem().string());
        std::string script;
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] != '\r' || text.substr(i, 2) != "\r\n")
                script += text[i] == '\0' ? ' ' : text[i];
        unsigned line = 1;
        file_ = file;
        const auto count_lines = [&](std::size_t from, std::size_t to) {
            line += static_cast<unsigned>(
                std::count(script.begin() + static_cast<std::ptrdiff_t>(from),
                           script.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
        };
        for (std::size_t at = 0; at < script.size();) {
            SafeTcl::Extent extent;
            try {
                if (close_bracket(script, at)) {
                    line_ = line;
                    note("a \"]\" is missing, and taken to be at the end of its word");
                }
                extent = tcl_.next_command(script, at);
            } catch (const std::exception& error) {
                std::size_t begin = at;
                while (begin < script.size() &&
                       std::isspace(static_cast<unsigned char>(script[begin])))
                    ++begin;
                count_lines(at, begin);
                line_ = line;
                fail(error.what());
            }
            count_lines(at, extent.begin);
            line_ = line;
            if (!extent.is_empty) evaluate(script.substr(extent.begin, extent.end - extent.begin));
            count_lines(extent.begin, extent.end);
            at = extent.end;
        }
        std::tie(file_, line_) = before;
        folder_ = qip_before;
        tcl_.set("quartus", "qip_path", folder_);
    }

    // Of a pin's index without its end, as in GPIO_1[22: gives it one, in an
    // assignment of one line.
    static bool close_bracket(std::string& script, std::size_t at) {
        if (script.compare(at, 4, "set_") != 0) return false;
        const std::size_t end = std::min(script.find('\n', at), script.size());
        const auto count = [&](char bracket) {
            return std::count(script.begin() + static_cast<std::ptrdiff_t>(at),
                              script.begin() + static_cast<std::ptrdiff_t>(end), bracket);
        };
        if (count('[') != count(']') + 1) return false;
        std::size_t last = script.rfind('[', end);
        if (script.find(']', last) < end) return false;
        while (++last < end && std::isalnum(static_cast<unsigned char>(script[last]))) {
        }
        script.insert(last, "]");
        return true;
    }

    void evaluate(std::string command) {
        // Paths of Windows: "\s" is no escape there.
        if (command.compare(0, 4, "set_") == 0)
            for (std::size_t i = 0; i + 1 < command.size(); ++i)
                if (command[i] == '\\' &&
                    (std::isalnum(static_cast<unsigned char>(command[i + 1])) ||
                     command[i + 1] == '_' || command[i + 1] == '.' || command[i + 1] == '\\')) {
                    command.insert(i, "\\");
                    i += 1 + (command[i + 2] == '\\');
                }
        try {
            tcl_.run(command);
        } catch (const ProjectError&) {  // of a command of ours
            throw;
        } catch (const std::exception& error) {
            fail(error.what());
        }
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw ProjectError{fmt::format("{}: this is wrong Tcl: {}", place(), why)};
    }
    std::string place() const { return fmt::format("{}:{}", file_.filename().string(), line_); }
    void note(const std::string& text) {
        settings_.notes.push_back(fmt::format("{}: {}", place(), text));
    }

    // ---- Commands ----

    std::string command(const Words& words) {
        const std::string& name = words[0];
        if (name == "source") {
            source(words.back());
        } else if (name == "file") {
            return of_file(words);
        } else if (name == "unknown") {
            return unknown({words.begin() + 1, words.end()});
        } else {
            assign(words);
        }
        return {};
    }

    // SW[3] is not for Tcl.
    std::string unknown(const Words& words) {
        if (words.empty()) return {};
        const std::string& name = words[0];
        const bool index = std::all_of(name.begin(), name.end(), [](unsigned char c) {
            return std::isdigit(c) || c == ':' || c == '.' || c == '*' || c == '-';
        });
        if (index) return "[" + name + "]";
        const bool sdc = lower(file_.extension().string()) == ".sdc";
        if (!sdc && !is_of_quartus(name))
            note(fmt::format("the command {} is passed over", name.substr(0, 40)));
        return {};
    }

    void source(const std::string& name) {
        std::error_code error;
        fs::path other = file_.parent_path() / name;
        if (!fs::is_regular_file(other, error)) return;
        if (depth_ >= DEEPEST_SOURCE) return;
        if (++sourced_ > MOST_SOURCED)
            throw ProjectError{
                fmt::format("{}: more than {} files are sourced; does one source itself?", place(),
                            MOST_SOURCED)};
        ++depth_;
        read(text_of(other), other);
        --depth_;
    }

    // The subcommands that have to do with names, and whether a file of the project is there.
    std::string of_file(const Words& words) {
        if (words.size() < 3) return {};
        const auto result = file_result(words, folder_);
        if (!result)
            throw ProjectError{fmt::format("{}: `file {}` is not for settings", place(), words[1])};
        return *result;
    }

    void assign(const Words& words) {
        const bool parameter = words[0] == "set_parameter";
        const bool location = words[0] == "set_location_assignment";
        Assignment a{location ? "LOCATION" : "", "", "", "", file_, line_, false};
        bool disabled = false, removed = false;
        for (std::size_t i = 1; i < words.size(); ++i) {
            const std::string& word = words[i];
            const bool more = i + 1 < words.size();
            if (word == "-to" && more)
                a.to = words[++i];
            else if (word == "-name" && more)
                a.name = words[++i];
            else if (word == "-library" && more)
                a.library = words[++i];
            else if (word == "-disable")
                disabled = true;
            else if (word == "-remove")
                removed = true;
            else if (word.size() > 1 && word[0] == '-' && std::isalpha(word[1]) != 0 && more)
                ++i;  // -section_id y
            else if (a.value.empty())
                a.value = word;
        }
        if (a.value.compare(0, folder_.size(), folder_) == 0) {
            a.value.erase(0, folder_.size());
            a.in_qip_folder = true;
        }
        a.to.erase(std::remove(a.to.begin(), a.to.end(), '\\'), a.to.end());  // KEY\[0\]
        if (parameter)  // whose -to names an instance
            a.to = std::exchange(a.name, a.to.empty() ? "PARAMETER" : "INSTANCE_PARAMETER");
        std::transform(a.name.begin(), a.name.end(), a.name.begin(), ::toupper);
        if (removed)
            remove(settings_.assignments, a);
        else if (!disabled)
            settings_.assignments.push_back(std::move(a));
    }

    SafeTcl tcl_;
    Settings settings_;
    fs::path file_;
    std::string folder_;  // of file_
    unsigned line_ = 0, depth_ = 0, sourced_ = 0;
};

}  // namespace

Settings settings_in(std::string_view text, const fs::path& file) {
    return SettingsScript{}.run(text, file);
}

Settings read_settings(const fs::path& file) { return settings_in(text_of(file), file); }

}  // namespace sim::project
