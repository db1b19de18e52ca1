#include "sim/vhdl/vhdl_memories.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "sim/verilog/edits.h"
#include "sim/vhdl/vhdl_tokens.h"

namespace sim::project {

namespace {

using At = std::size_t;  // a token's number

class Memories {
public:
    Memories(const std::string& text, const InitialWords& words)
        : tokens_{vhdl_tokens(text)}, low_{in_lower_case(tokens_.all)}, words_{words} {}

    std::string run() {
        // attribute ram_init_file of NAME : signal is "FILE" ;
        for (At i = 0; i + 8 < low_.size(); ++i)
            if (is(i, "attribute") && is(i + 1, "ram_init_file") && is(i + 2, "of") &&
                is(i + 4, ":") && is(i + 6, "is") && is(i + 8, ";"))
                initialise(i + 3, text_at(i + 7));
        return changed_text(tokens_, edits_);
    }

private:
    bool is(At i, std::string_view what) const { return i < low_.size() && low_[i] == what; }

    // "FILE", or the constant that it is.
    std::string text_at(At i) const {
        const std::string& value = low_[i];
        if (value[0] == '"') return value.substr(1, value.size() - 2);
        for (At c = 0; c + 5 < low_.size(); ++c)
            if (is(c, "constant") && is(c + 1, value) && is(c + 3, "string") && is(c + 4, ":=") &&
                low_[c + 5][0] == '"')
                return text_at(c + 5);
        return {};
    }

    // The declaration that is the last one before `name`: signal NAME : TYPE ;
    void initialise(At name, const std::string& file) {
        At i = name;
        do
            if (i-- == 0) return;
        while (!is(i + 1, ":") || low_[i] != low_[name] || i == 0 ||
               !(is(i - 1, "signal") || is(i - 1, "variable")));
        if (file.empty() || !is(i + 3, ";")) return;
        const std::optional<unsigned> width = width_of(low_[i + 2]);
        if (!width) return;
        std::string all;
        std::size_t address = 0;
        for (const std::string& word : words_(file, tokens_.all[name].line, *width)) {
            if (word.find('1') != std::string::npos)
                all += fmt::format("{} => \"{}\", ", address, word);
            ++address;
        }
        edits_.after[i + 2] += fmt::format(" := ({}others => (others => '0'))", all);
    }

    // Of the words of the array TYPE; 0: it is not a number.  Nothing: they are no vectors of bits.
    std::optional<unsigned> width_of(const std::string& type) const {
        for (At i = 0; i + 1 < low_.size(); ++i)
            if (is(i, "type") && is(i + 1, type))
                for (At of = i; of < low_.size() && !is(of, ";"); ++of)
                    if (is(of, "of")) return bits_at(of + 1);
        return {};
    }
    std::optional<unsigned> bits_at(At i) const {
        static constexpr std::string_view VECTORS[] = {"std_logic_vector", "std_ulogic_vector",
                                                       "unsigned", "signed", "bit_vector"};
        if (i >= low_.size()) return {};
        if (std::find(std::begin(VECTORS), std::end(VECTORS), low_[i]) == std::end(VECTORS)) {
            for (At s = 0; s + 3 < i; ++s)  // subtype NAME is ...
                if (is(s, "subtype") && is(s + 1, low_[i])) return bits_at(s + 3);
            return {};
        }
        const auto is_number = [this](At n) {
            return n < low_.size() && tokens_.all[n].kind == Token::Kind::NUMBER &&
                   low_[n].size() < 6 &&
                   low_[n].find_first_not_of("0123456789") == std::string::npos;
        };
        if (!is(i + 1, "(") || !is_number(i + 2) || !is_number(i + 4) || !is(i + 5, ")")) return 0;
        return static_cast<unsigned>(std::abs(std::stoi(low_[i + 2]) - std::stoi(low_[i + 4])) + 1);
    }

    const Tokens tokens_;
    const std::vector<std::string> low_;
    const InitialWords& words_;
    Edits edits_;
};

}  // namespace

std::string with_initial_words(const std::string& text, const InitialWords& words) {
    return Memories{text, words}.run();
}

}  // namespace sim::project
