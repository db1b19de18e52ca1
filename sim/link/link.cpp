#include "sim/link/link.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "sim/cpu/elf.h"
#include "sim/files/whole_file.h"
#include "sim/process/run_command.h"
#include "sim/project/project.h"
#include "sim/project/qsys/devices.h"
#include "sim/project/settings.h"
#include "sim/project/tools.h"
#include "sim/report/exit_code.h"
#include "sim/run/options.h"
#include "sim/text/messages.h"

namespace sim {

namespace fs = std::filesystem;

namespace {

using project::ProjectError;

constexpr const char* PREFIX = "arm-linux-gnueabihf-";
constexpr unsigned LIMIT_S = 600;
// KMOD_REGIONS and KMOD_INTERRUPTS of sw/kmod/nodes.h
constexpr std::size_t MOST_REGIONS = 8, MOST_INTERRUPTS = 8;

// It includes a header that only the kernel has, itself or by its own headers.
bool includes_kernel(const fs::path& file, std::set<fs::path>& seen) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || !seen.insert(file).second) return false;
    static const std::regex KERNEL{
        R"(#\s*include\s*<(linux/(module|init|io|of|of_address|platform_device|interrupt|slab|)"
        R"(cdev|device|uaccess|delay|miscdevice|spinlock|mutex|workqueue|kthread)|)"
        R"(asm/(io|uaccess))\.h>)"};
    static const std::regex OWN{R"re(#\s*include\s*"([^"\n]+)")re"};
    const std::string text = project::text_of(file);
    if (std::regex_search(text, KERNEL)) return true;
    for (std::sregex_iterator at{text.begin(), text.end(), OWN}, end; at != end; ++at)
        if (includes_kernel(file.parent_path() / (*at)[1].str(), seen)) return true;
    return false;
}

bool is_module(const fs::path& file) {
    std::set<fs::path> seen;
    return file.extension() == ".c" && includes_kernel(file, seen);
}

// Modules that are linked apart, but loaded together, mostly have different places.
std::uint32_t place_of(const std::string& name) {
    std::uint32_t hash = 2166136261;  // FNV-1a
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619;
    return KERNEL_BASE + hash % KERNEL_PLACES * KERNEL_PLACE_BYTES;
}

class TemporaryFolder {
public:
    TemporaryFolder() {
        const char* parent = std::getenv("TMPDIR");
        std::string name = (fs::path{parent ? parent : "/tmp"} / "de1sim-link-XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw ProjectError{
                fmt::format("no folder can be made in {}", fs::path{name}.parent_path().string())};
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code error;
        fs::remove_all(path_, error);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

// The kernel's headers that a module names, also by its own headers, lead to kmod.h.
void write_headers(const fs::path& source, const fs::path& folder, std::set<fs::path>& seen) {
    std::error_code error;
    if (!fs::is_regular_file(source, error) || !seen.insert(source).second) return;
    static const std::regex INCLUDE{R"(#\s*include\s*([<"])([^>"\n]+)[>"])"};
    const std::string text = project::text_of(source);
    for (std::sregex_iterator at{text.begin(), text.end(), INCLUDE}, end; at != end; ++at) {
        const std::string name = (*at)[2];
        if ((*at)[1] == "\"") write_headers(source.parent_path() / name, folder, seen);
        if (name.find("..") != std::string::npos || name[0] == '/') continue;
        static const std::regex KERNELS{R"((linux|asm|asm-generic|uapi|mach|generated)/.*)"};
        if (!std::regex_match(name, KERNELS)) continue;
        fs::create_directories((folder / name).parent_path());
        write_whole_file(folder / name, "#include \"kmod.h\"\n");
    }
}

// kmod_nodes of sw/kmod/nodes.h: a node per module of the system.
std::string nodes_text(const std::vector<project::qsys::Device>& devices) {
    std::string lists, nodes;
    for (std::size_t n = 0; n < devices.size(); ++n) {
        const project::qsys::Device& d = devices[n];
        if (n && devices[n - 1].instance == d.instance) continue;
        std::string first, bytes;
        unsigned regions = 0;
        for (std::size_t m = n;
             m < devices.size() && devices[m].instance == d.instance && regions < MOST_REGIONS;
             ++m, ++regions) {
            first += fmt::format("0x{:08x}, ", devices[m].window + devices[m].base);
            bytes += fmt::format("0x{:x}, ", devices[m].span);
        }
        lists += fmt::format("static const char* const compatible_{}[] = {{", n);
        for (const std::string& name : d.compatible) lists += '"' + name + "\", ";
        lists += "0};\n";
        std::string interrupts;
        const std::size_t interrupt_count = std::min(d.interrupts.size(), MOST_INTERRUPTS);
        for (std::size_t i = 0; i < interrupt_count; ++i)
            interrupts += fmt::format("{}, ", d.interrupts[i]);
        nodes += fmt::format("    {{\"{}\", compatible_{}, {}, {{{}}}, {{{}}}, {}, {{{}}}}},\n",
                             d.instance, n, regions, first, bytes, interrupt_count, interrupts);
    }
    return fmt::format(
        "#include <stdint.h>\n#include \"nodes.h\"\n{}"
        "struct device_node kmod_nodes[] = {{\n{}    {{0}}\n}};\n",
        lists, nodes);
}

// "dial.c:12:5: error: implicit declaration of function 'request_irq'".
void name_missing_functions(const std::string& output) {
    static const std::regex IMPLICIT{
        R"(([^\n]*:\d+):\d+: error: (?:implicit declaration of function|)"
        R"(type defaults to 'int' in declaration of) '(\w+)')"};
    std::string first, others;
    std::set<std::string> names;
    for (std::sregex_iterator at{output.begin(), output.end(), IMPLICIT}, end; at != end; ++at) {
        if (!names.insert((*at)[2]).second) continue;
        if (first.empty())
            first = fmt::format("{}: the kernel's function {}()", (*at)[1].str(), (*at)[2].str());
        else
            others += fmt::format("{} {}()", others.empty() ? "; nor are" : ",", (*at)[2].str());
    }
    if (first.empty()) return;
    throw ProjectError{
        fmt::format("{} is not one of those that a module can call here{}; {} has "
                    "them all",
                    first, others, (project::data_folder() / "kmod").string())};
}

class Linker {
public:
    explicit Linker(const LinkOptions& options) : options_{options} {}

    int run() {
        for (const fs::path& file : options_.files)
            if (std::error_code error; !fs::is_regular_file(file, error))
                throw ProjectError{fmt::format("{}: there is no such file", file.string())};
        std::vector<std::string> modules, program;
        std::string name;  // of the first module
        for (const fs::path& file : options_.files) {
            const std::string extension = file.extension().string();
            if (extension == ".o" || extension == ".a") {
                program.push_back(fs::absolute(file).string());
            } else if (is_module(file)) {
                if (name.empty()) name = file.stem().string();
                modules.push_back(module(file));
            } else {
                is_cpp_ |= extension == ".cpp" || extension == ".cc" || extension == ".cxx";
                program.push_back(compiled_program(file));
            }
        }
        if (modules.empty())
            throw ProjectError{
                fmt::format("{}: none of the files is a kernel module: none includes "
                            "<linux/module.h>",
                            options_.files.front().string())};
        const fs::path kernel = folder_.path() / "modules";
        if (!link_modules(std::move(modules), name, kernel)) return WRONG_INPUT;
        if (program.empty())
            return place(kernel, options_.out.empty() ? fs::path{name + ".ko"} : options_.out);
        const fs::path linked = folder_.path() / "program";
        if (!link_program(std::move(program), kernel, name, linked)) return WRONG_INPUT;
        return place(linked, options_.out.empty() ? fs::path{"program.elf"} : options_.out);
    }

private:
    std::vector<project::qsys::Device> devices() const {
        if (options_.project.place.empty()) return {};
        const project::Project project = project::read_project(options_.project.request());
        for (const auto& system : project.systems)
            if (system.has_processor) return system.devices;
        throw ProjectError{fmt::format("{} has no Platform Designer system with the processor",
                                       options_.project.place.string())};
    }

    std::string compiled(const char* compiler, std::vector<std::string> command,
                         const fs::path& file) {
        const std::string object = (folder_.path() / fmt::format("{}.o", object_count_++)).string();
        command.insert(command.begin(), PREFIX + std::string{compiler});
        command.insert(command.end(), {file.string(), "-o", object});
        if (!compiles(command)) throw Failed{};
        return object;
    }

    bool link_modules(std::vector<std::string> objects, const std::string& name,
                      const fs::path& out) {
        const fs::path kmod = project::data_folder() / "kmod";
        write_whole_file(folder_.path() / "nodes.c", nodes_text(devices()));
        const std::vector<std::string> own{"-std=gnu11", "-O2", "-g", "-I" + kmod.string(), "-c"};
        separate_names(objects);
        objects.push_back(compiled("gcc", own, folder_.path() / "nodes.c"));
        for (const char* file : {"kmod.c", "kmod_attributes.c", "kmod_files.c", "kmod_format.c",
                                 "kmod_later.c", "kmod_library.c", "kmod_sleep.c"})
            objects.push_back(compiled("gcc", own, kmod / file));
        std::vector<std::string> command{PREFIX + std::string{"gcc"}, "-static", "-pthread",
                                         fmt::format("-Wl,-Ttext-segment=0x{:x}", place_of(name))};
        command.insert(command.end(), objects.begin(), objects.end());
        command.insert(command.end(), {"-o", out.string()});
        return compiles(command);
    }

    // Makes a global name that several modules define local to each of them, as the kernel's loader
    // keeps it; one that a module exports stays global.
    void separate_names(const std::vector<std::string>& modules) {
        static const std::regex DEFINED{R"(^\w+ [BDRTV] (\w+)$)", std::regex::multiline};
        std::map<std::string, unsigned> counts;
        for (const std::string& object : modules) {
            const std::string names = output({"nm", "-g", "--defined-only", object});
            for (std::sregex_iterator at{names.begin(), names.end(), DEFINED}, end; at != end; ++at)
                ++counts[(*at)[1]];
        }
        std::vector<std::string> command{"objcopy"};
        for (const auto& [name, count] : counts)
            if (count > 1 && !exported_.count(name)) command.push_back("--localize-symbol=" + name);
        if (command.size() > 1)
            for (const std::string& object : modules) {
                command.push_back(object);
                output(command);
                command.pop_back();
            }
    }

    // With the modules in a section of its own, which is loaded before it.
    bool link_program(std::vector<std::string> objects, const fs::path& modules,
                      const std::string& name, const fs::path& out) {
        write_whole_file(folder_.path() / "modules.S",
                         fmt::format(".section {}{},\"\",%progbits\n.incbin \"{}\"\n"
                                     ".section .note.GNU-stack,\"\",%progbits\n",
                                     MODULES_SECTION, name, modules.string()));
        objects.push_back(compiled("gcc", {"-c"}, folder_.path() / "modules.S"));
        std::vector<std::string> command{PREFIX + std::string{is_cpp_ ? "g++" : "gcc"}};
        command.insert(command.end(), objects.begin(), objects.end());
        command.insert(command.end(), options_.arguments.begin(), options_.arguments.end());
        command.insert(command.end(), {"-o", out.string()});
        std::vector<std::string> whole = command;
        whole.emplace_back("-static");
        // Debian's libusb, for one, cannot be linked statically.
        const Outcome outcome = run(whole);
        return outcome.code == 0 ? tell(outcome) : compiles(command);
    }

    // Beside the result first, so that this is never half there.
    static int place(const fs::path& made, const fs::path& wanted) {
        const fs::path out = fs::absolute(wanted), half = out.string() + ".part";
        std::error_code error;
        fs::copy_file(made, half, fs::copy_options::overwrite_existing, error);
        if (!error) fs::rename(half, out, error);
        if (error) throw ProjectError{fmt::format("{}: {}", out.string(), error.message())};
        return PASSED;
    }

    // Of one of binutils' programs.
    static std::string output(std::vector<std::string> command) {
        command[0] = PREFIX + command[0];
        const Outcome outcome = run_command(command, fs::current_path(), LIMIT_S);
        if (outcome.code != 0)
            throw ProjectError{fmt::format("{}: {}", command[0], outcome.output)};
        return outcome.output;
    }

    std::string module(const fs::path& file) {
        static const std::regex EXPORT{R"(EXPORT_SYMBOL(?:_GPL)?\s*\(\s*(\w+))"};
        const std::string text = project::text_of(file);
        for (std::sregex_iterator at{text.begin(), text.end(), EXPORT}, end; at != end; ++at)
            exported_.insert((*at)[1]);
        const fs::path kmod = project::data_folder() / "kmod";
        const fs::path headers = folder_.path() / "headers";
        std::set<fs::path> seen;
        write_headers(fs::absolute(file), headers, seen);
        std::string name = file.stem().string();
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        std::vector<std::string> command{"-std=gnu11",
                                         "-O2",
                                         "-g",
                                         "-ffreestanding",
                                         "-fno-strict-aliasing",
                                         "-fno-strict-overflow",
                                         "-fno-delete-null-pointer-checks",
                                         "-D__KERNEL__",
                                         "-DMODULE",
                                         "-DKBUILD_MODNAME=\"" + name + "\"",
                                         "-I" + headers.string(),
                                         "-I" + kmod.string(),
                                         "-Wno-error=incompatible-pointer-types",
                                         "-Wno-error=int-conversion",
                                         "-Werror=implicit-function-declaration",
                                         "-Werror=implicit-int"};
        add_compiler_arguments(command);
        command.push_back("-c");
        return compiled("gcc", command, file);
    }

    std::string compiled_program(const fs::path& file) {
        std::vector<std::string> command{"-O2", "-g"};
        add_compiler_arguments(command);
        command.push_back("-c");
        return compiled(file.extension() == ".c" || file.extension() == ".S" ? "gcc" : "g++",
                        command, file);
    }

    // Those that are not the linker's.
    void add_compiler_arguments(std::vector<std::string>& command) const {
        for (const std::string& word : options_.arguments)
            if (word.rfind("-l", 0) != 0 && word.rfind("-L", 0) != 0 && word.rfind("-Wl", 0) != 0)
                command.push_back(word);
    }

    bool compiles(const std::vector<std::string>& command) { return tell(run(command)); }

    Outcome run(const std::vector<std::string>& command) const {
        std::vector<std::string> in_english{"env", "LC_ALL=C"};
        in_english.insert(in_english.end(), command.begin(), command.end());
        const Outcome outcome = run_command(in_english, fs::current_path(), LIMIT_S);
        if (outcome.code == 127)
            throw ProjectError{command[0] +
                               " is not installed: apt install g++-arm-linux-gnueabihf (a package "
                               "of Debian)"};
        if (outcome.code == TIMED_OUT)
            throw ProjectError{fmt::format("{} has not ended in {} s", command[0], LIMIT_S)};
        return outcome;
    }

    // Prints what it has said; whether it has succeeded.
    bool tell(const Outcome& outcome) {
        name_missing_functions(outcome.output);
        std::size_t at = 0;
        while (at < outcome.output.size()) {
            const std::size_t end = std::min(outcome.output.find('\n', at), outcome.output.size());
            message(std::string_view{outcome.output}.substr(at, end - at));
            at = end + 1;
        }
        return outcome.code == 0;
    }

public:
    struct Failed {};  // the compiler has said why

private:
    const LinkOptions& options_;
    const TemporaryFolder folder_;
    unsigned object_count_ = 0;
    std::set<std::string> exported_;  // by a module for others
    bool is_cpp_ = false;
};

}  // namespace

void add_link_options(CLI::App& command, LinkOptions& options) {
    command
        .add_option("FILE", options.files,
                    "kernel modules and the program that uses them: .c, .cpp, .S, .o, .a")
        ->required();
    command
        .add_option("--project", options.project.place,
                    "the .qsf, .qpf or folder with the Platform Designer system that modules find "
                    "their devices in")
        ->check(named);
    command.add_option("-o,--output", options.out,
                       "the program; without one, NAME.ko of the modules");
    add_project_options(command, options.project);
    command.footer("What follows -- are arguments of the compiler: -lm, -I FOLDER.");
}

int link_program(const LinkOptions& options) {
    try {
        return Linker{options}.run();
    } catch (const Linker::Failed&) {
        complain("nothing is made: a file does not compile");
        return WRONG_INPUT;
    }
}

}  // namespace sim
