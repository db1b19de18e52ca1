#include "sim/project/init_checks.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/project/formats.h"
#include "sim/project/memory_image.h"
#include "sim/verilog/project_error.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t MOST_WORDS = 1 << 18;  // of 16 bits, as many as the chip's blocks have

// The words of $readmemh and $readmemb: digits, @ and an address, comments as in Verilog.
void check_words(const fs::path& file, bool is_hex) {
    const std::string text = text_of(file);
    unsigned line = 1;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (text.compare(at, 2, "//") == 0) {
            end = text.find('\n', at);
        } else if (text.compare(at, 2, "/*") == 0) {
            end = text.find("*/", at + 2);
            if (end != std::string::npos) end += 2;
        } else if (!std::isspace(static_cast<unsigned char>(text[at]))) {
            end = std::min(text.find_first_of(" \t\r\n\v\f/", at + 1), text.size());
            const bool is_address = text[at] == '@';
            // Verilator reads no z.
            const char* digits = is_address ? "0123456789abcdefABCDEF_"
                                 : is_hex   ? "0123456789abcdefABCDEFxX_"
                                            : "01xX_";
            const std::string word = text.substr(at, end - at);
            if (word.find_first_not_of(digits, is_address) != std::string::npos ||
                word.size() == is_address)
                throw std::runtime_error(fmt::format(
                    "{}:{}: \"{}\", expected {} digits of a word, or @ and an address",
                    file.string(), line, word.substr(0, 40), is_hex ? "hexadecimal" : "binary"));
        }
        end = std::min(end, text.size());
        for (; at < end; ++at) line += text[at] == '\n';
    }
}

}  // namespace

InitFolders init_folders(const Project& project) {
    InitFolders folders{project.folder, {}};
    for (const SourceFile& source : project.sources)
        folders.sources.push_back(source.path.parent_path());
    return folders;
}

void check_init_files(const std::vector<InitFile>& files, const InitFolders& folders) {
    std::set<std::pair<fs::path, std::string>> checked;
    for (const InitFile& wanted : files) {
        const auto file = find_init_file(wanted.name, folders);
        if (!file || !checked.emplace(*file, wanted.reader).second) continue;
        try {
            if (wanted.reader.rfind("$readmem", 0) == 0)
                check_words(*file, wanted.reader == "$readmemh");
            else
                read_memory_image(*file, 32, 0);
        } catch (const std::runtime_error& error) {
            std::string what = error.what();
            const std::string path = file->string();
            if (what.compare(0, path.size(), path) == 0)
                what.replace(0, path.size(), file->lexically_relative(folders.project).string());
            throw ProjectError{
                fmt::format("{}, as the initial words of the memory at {}", what, wanted.place)};
        }
    }
}

std::vector<std::string> initial_words(const InitFile& wanted, const InitFolders& folders,
                                       unsigned width) {
    const auto file = find_init_file(wanted.name, folders);
    if (!file) return {};
    check_init_files({wanted}, folders);
    std::size_t depth = MOST_WORDS;
    const std::string text = text_of(*file);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos || text[first] != ':') {
        const MifSize size = size_of_mif(text, file->string());
        depth = std::min(size.depth, MOST_WORDS);
        if (width == 0) width = size.width;
    }
    if (width == 0) return {};
    const MemoryImage image = read_memory_image(*file, width, depth);
    std::vector<std::string> words;
    for (std::size_t n = 0; n < depth; ++n) {
        std::string word;
        for (std::size_t bit = width; bit-- > 0;)
            word += image.part(n, bit / 32) >> bit % 32 & 1 ? '1' : '0';
        words.push_back(std::move(word));
    }
    return words;
}

}  // namespace sim::project
