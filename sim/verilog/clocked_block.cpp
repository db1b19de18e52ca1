#include "sim/verilog/clocked_block.h"

#include <algorithm>
#include <utility>

namespace sim::project {

namespace {

constexpr unsigned MOST_NESTED_STATEMENTS = 500;

}  // namespace

ClockedBlock::ClockedBlock(const std::vector<Token>& all, std::size_t begin)
    : all_{all}, begin_{begin}, at_{begin} {
    statement();
}

const Token& ClockedBlock::here() const {
    if (at_ >= all_.size()) throw NotUnderstood{};
    return all_[at_];
}
bool ClockedBlock::accept(std::string_view text) {
    if (!here().is(text)) return false;
    ++at_;
    return true;
}
void ClockedBlock::expect(std::string_view text) {
    if (!accept(text)) throw NotUnderstood{};
}
bool ClockedBlock::is_one_of(std::initializer_list<std::string_view> words) const {
    return std::find(words.begin(), words.end(), here().text) != words.end();
}

// Everything up to `end` outside of brackets is read; `end` is taken.
void ClockedBlock::read_to(std::string_view end) {
    for (int depth = 0; depth != 0 || !here().is(end); ++at_) {
        depth += is_one_of({"(", "[", "{"}) - is_one_of({")", "]", "}"});
        if (depth < 0) throw NotUnderstood{};
        if (assigned_.count(here().text)) read_.insert(here().text);
    }
    ++at_;
}
void ClockedBlock::condition() {
    expect("(");
    read_to(")");
}

void ClockedBlock::statement() {
    if (nested_ > MOST_NESTED_STATEMENTS) throw NotUnderstood{};
    ++nested_;
    if (is_one_of({"unique", "unique0", "priority"})) ++at_;
    if (accept(";")) {
    } else if (accept("begin")) {
        sequence();
    } else if (accept("if")) {
        branches();
    } else if (is_one_of({"case", "casex", "casez"})) {
        choices();
    } else if (is_one_of({"for", "while", "repeat"})) {
        loop();
    } else if (here().text[0] == '$') {
        read_to(";");
    } else {
        assignment();
    }
    --nested_;
}

void ClockedBlock::sequence() {
    if (accept(":")) ++at_;
    while (!accept("end")) {
        if (is_one_of({"automatic", "static", "reg", "integer", "logic", "int", "bit", "byte"}))
            local();
        else
            statement();
    }
    if (at_ + 1 < all_.size() && accept(":")) ++at_;
}
void ClockedBlock::local() {
    for (; !here().is(";"); ++at_) {
        read_.insert(here().text);
        locals_.insert(here().text);
    }
    ++at_;
}

void ClockedBlock::branches() {
    condition();
    const Names before = assigned_;
    statement();
    if (at_ >= all_.size() || !here().is("else")) return;
    ++at_;
    const Names after = std::exchange(assigned_, before);
    statement();
    assigned_.insert(after.begin(), after.end());
}

void ClockedBlock::choices() {
    ++at_;
    condition();
    accept("inside");
    const Names before = assigned_;
    Names after = before;
    while (!accept("endcase")) {
        assigned_ = before;
        if (!accept("default"))
            read_to(":");
        else
            accept(":");
        statement();
        after.insert(assigned_.begin(), assigned_.end());
    }
    assigned_ = after;
}

// What is assigned in one round may be read in the next; so all of it counts as read.
void ClockedBlock::loop() {
    const std::size_t first = at_++;
    expect("(");
    for (int depth = 1; depth; ++at_) {
        depth += here().is("(") - here().is(")");
        if (here().kind == Token::Kind::NAME && all_[first].is("for")) loops_.insert(here().text);
    }
    statement();
    for (std::size_t i = first; i < at_; ++i)
        if (all_[i].kind == Token::Kind::NAME) read_.insert(all_[i].text);
}

// "n[3:0] = d;", "{a, b} <= d;", "n += d;", "n++;", "++n;"; or a task: "t;", "t(d);"
void ClockedBlock::assignment() {
    Assignment a{{}, at_, at_, at_, true, true};
    const auto doubled = [this](std::string_view sign) {
        return here().is(sign) && at_ + 1 < all_.size() && all_[at_ + 1].is(sign);
    };
    const bool leads = doubled("+") || doubled("-");
    if (leads) at_ += 2;
    if (accept("{")) {
        for (; !accept("}"); accept(",")) a.targets.push_back(target());
    } else {
        a.targets.push_back(target());
        if (here().is(";") || here().is("(")) {
            calls_ = true;
            return read_to(";");
        }
    }
    a.sign = at_;
    if (leads || doubled("+") || doubled("-")) {
        a.is_plain = false;
        if (!leads) at_ += 2;
    } else if (!accept("=")) {
        a.is_blocking = !accept("<");
        if (a.is_blocking) {
            a.is_plain = false;
            while (is_one_of({"+", "-", "*", "/", "%", "&", "|", "^", "<", ">"})) ++at_;
            if (at_ == a.sign) throw NotUnderstood{};
        } else if (accept("<")) {  // <<=
            a.is_blocking = true;
            a.is_plain = false;
            accept("<");
        }
        expect("=");
    }
    if (!a.is_plain)
        for (const Target& t : a.targets) read_.insert(t.name);
    read_to(";");
    a.end = at_ - 1;
    for (const Target& t : a.targets) assigned_.insert(t.name);
    assignments_.push_back(std::move(a));
}

ClockedBlock::Target ClockedBlock::target() {
    if (here().kind != Token::Kind::NAME || is_keyword(here().text)) throw NotUnderstood{};
    Target t{here().text, at_, at_};
    ++at_;
    while (here().is("[") || here().is(".")) {
        if (accept("["))
            read_to("]");
        else
            at_ += 2;
    }
    t.end = at_;
    return t;
}

}  // namespace sim::project
