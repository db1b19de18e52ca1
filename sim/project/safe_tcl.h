// safe_tcl.h - runs a script in Tcl, which can do nothing but call the commands that it is given
//
// It is Tcl's safe interpreter, also without events, channels and packages: no files, no network,
// no other program.  It runs at most a million commands, and 2 s.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct Tcl_Interp;

namespace sim::project {

class SafeTcl {
public:
    using Words = std::vector<std::string>;
    // What a command does, with its name in front of the words; the result is the command's.
    // An exception ends the script.
    using Command = std::function<std::string(const Words&)>;

    SafeTcl();
    ~SafeTcl();
    SafeTcl(const SafeTcl&) = delete;
    SafeTcl& operator=(const SafeTcl&) = delete;

    // In place of Tcl's own, if there is one.  "unknown" is called for all that is no command.
    void add(const std::string& name, Command command);
    void set(const std::string& array, const std::string& index, const std::string& value);

    // Executes this and returns its result.  What a command of ours throws comes out of it;
    // std::runtime_error with Tcl's words: the script is wrong.
    std::string run(const std::string& script);
    // The command at the beginning of the text, up to its end; npos: it does not end.
    struct Extent {
        std::size_t begin, end;  // `begin` is after blanks and comments
        bool is_empty;
    };
    // std::runtime_error: as run().
    Extent next_command(const std::string& text, std::size_t from);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// What Tcl's `file` says of paths, which are seen from `folder`, with the command and at least two
// words; nothing: what it is asked is not answered here.
std::optional<std::string> file_result(const SafeTcl::Words& words,
                                       const std::filesystem::path& folder);

// The words of a list.  std::runtime_error: it is none.
std::vector<std::string> words_of_list(const std::string& list);

}  // namespace sim::project
