#include "sim/project/registers.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace sim::project {

namespace {

using Names = std::set<std::string_view>;

struct NotUnderstood {};  // the block stays as it is

// Follows the statements of one clocked block, and which variables may have been assigned before.
class ClockedBlock {
public:
    ClockedBlock(const std::vector<Token>& all, std::size_t begin) : all_{all}, at_{begin} {
        statement();
    }

    std::set<std::size_t> registers() {
        // One "=" for several variables is that of a register only if all of them are.
        for (std::size_t before = ~std::size_t{0}; before != read_.size();) {
            before = read_.size();
            for (const auto& [sign, names] : signs_)
                if (std::any_of(names.begin(), names.end(), [&](auto n) { return read_.count(n); }))
                    read_.insert(names.begin(), names.end());
        }
        std::set<std::size_t> result;
        for (const auto& [sign, names] : signs_)
            if (!read_.count(*names.begin())) result.insert(sign);
        return result;
    }

private:
    const Token& here() const {
        if (at_ >= all_.size()) throw NotUnderstood{};
        return all_[at_];
    }
    bool take(std::string_view text) {
        if (!here().is(text)) return false;
        ++at_;
        return true;
    }
    void expect(std::string_view text) {
        if (!take(text)) throw NotUnderstood{};
    }
    bool is_one_of(std::initializer_list<std::string_view> words) const {
        return std::find(words.begin(), words.end(), here().text) != words.end();
    }

    // Everything up to `end` outside of brackets is read; `end` is taken.
    void read_to(std::string_view end) {
        for (int depth = 0; depth != 0 || !here().is(end); ++at_) {
            depth += is_one_of({"(", "[", "{"}) - is_one_of({")", "]", "}"});
            if (depth < 0) throw NotUnderstood{};
            if (assigned_.count(here().text)) read_.insert(here().text);
        }
        ++at_;
    }
    void condition() {
        expect("(");
        read_to(")");
    }

    void statement() {
        if (take(";")) return;
        if (take("begin")) return sequence();
        if (take("if")) return branches();
        if (is_one_of({"case", "casex", "casez"})) return choices();
        if (is_one_of({"for", "while", "repeat"})) return loop();
        if (here().text[0] == '$') return read_to(";");
        assignment();
    }

    void sequence() {
        if (take(":")) ++at_;
        while (!take("end")) {
            if (is_one_of({"reg", "integer", "logic", "int"}))
                local();
            else
                statement();
        }
    }
    void local() {
        for (; !here().is(";"); ++at_) read_.insert(here().text);
        ++at_;
    }

    void branches() {
        condition();
        const Names before = assigned_;
        statement();
        if (at_ >= all_.size() || !here().is("else")) return;
        ++at_;
        const Names after = std::exchange(assigned_, before);
        statement();
        assigned_.insert(after.begin(), after.end());
    }

    void choices() {
        ++at_;
        condition();
        const Names before = assigned_;
        Names after = before;
        while (!take("endcase")) {
            assigned_ = before;
            if (!take("default"))
                read_to(":");
            else
                take(":");
            statement();
            after.insert(assigned_.begin(), assigned_.end());
        }
        assigned_ = after;
    }

    // What is assigned in one round may be read in the next; so all of it counts as read.
    void loop() {
        const std::size_t first = at_++;
        expect("(");
        for (int depth = 1; depth; ++at_) depth += here().is("(") - here().is(")");
        statement();
        for (std::size_t i = first; i < at_; ++i)
            if (all_[i].kind == Token::Kind::NAME) read_.insert(all_[i].text);
    }

    void assignment() {
        std::vector<std::string_view> names;
        if (take("{")) {
            for (; !take("}"); take(",")) names.push_back(target());
        } else {
            names.push_back(target());
        }
        const std::size_t sign = at_;
        const bool blocking = take("=");
        if (!blocking) {
            expect("<");
            expect("=");
        }
        read_to(";");
        assigned_.insert(names.begin(), names.end());
        if (blocking) signs_[sign] = names;
    }
    std::string_view target() {
        if (here().kind != Token::Kind::NAME || is_keyword(here().text)) throw NotUnderstood{};
        const std::string_view name = all_[at_++].text;
        while (take("[")) read_to("]");
        return name;
    }

    const std::vector<Token>& all_;
    std::size_t at_;
    Names assigned_, read_;  // up to here; and read after that somewhere
    std::map<std::size_t, std::vector<std::string_view>> signs_;
};

}  // namespace

void make_registers(const Tokens& tokens, Edits& edits) {
    const std::vector<Token>& all = tokens.all;
    for (std::size_t i = 0; i + 2 < all.size(); ++i) {
        if (!all[i].is("always") || !all[i + 1].is("@") || !all[i + 2].is("(")) continue;
        std::size_t at = i + 3;
        bool clocked = false;
        for (int depth = 1; depth && at < all.size(); ++at) {
            depth += all[at].is("(") - all[at].is(")");
            clocked |= all[at].is("posedge") || all[at].is("negedge");
        }
        if (!clocked) continue;
        try {
            for (const std::size_t sign : ClockedBlock{all, at}.registers())
                edits.before[sign] += "<";
        } catch (const NotUnderstood&) {
        }
    }
}

}  // namespace sim::project
