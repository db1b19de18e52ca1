// words.cpp - edit distance and quoting
#include "sim/text/words.h"

#include <algorithm>
#include <numeric>

#include "sim/text/printable.h"

namespace sim {

namespace {

constexpr std::size_t MAX_QUOTED_BYTES = 60;
constexpr std::size_t MAX_WORD_BYTES = 40;  // longer ones are no typing mistake, and cost time

// Letters put in, left out, replaced, or swapped with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1), above(row), above2(row);
    std::iota(above.begin(), above.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] =
                std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], above2[j - 2] + 1);
        }
        above2.swap(above);
        above.swap(row);
    }
    return above[b.size()];
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t least = std::min<std::size_t>(2, word.size() / 3) + 1;
    if (word.size() > MAX_WORD_BYTES) return best;
    for (const auto& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance >= least) continue;
        least = distance;
        best = candidate;
    }
    return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string near = nearest(word, candidates);
    return near.empty() ? "" : " (did you mean \"" + near + "\"?)";
}

std::string list_of(const std::vector<std::string>& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i)
        out += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return out;
}

std::string in_quotes(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && end < MAX_QUOTED_BYTES) next_utf8(text, end);
    const bool cut = end < text.size();
    return "\"" + printable(text.substr(0, end)) + (cut ? "...\"" : "\"");
}

}  // namespace sim
