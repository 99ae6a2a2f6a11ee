#include "ripstop/io/svg/style/svg_css.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include "ripstop/base/text/lower_case.h"
#include "ripstop/io/svg/style/svg_document.h"
#include "ripstop/io/svg/values/svg_path.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr int deepest_rules = 32;  // nesting of blocks of rules

bool is_css_blank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool is_letter_of_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 128;
}

std::string without_comments(std::string_view text) {
    std::string bare;
    for (std::size_t at; (at = text.find("/*")) != std::string_view::npos;) {
        bare += text.substr(0, at);
        bare += ' ';
        const std::size_t end = text.find("*/", at + 2);
        if (end == std::string_view::npos) return bare;
        text.remove_prefix(end + 2);
    }
    return bare += text;
}

/// The position of the first of `ends` outside of strings, brackets and blocks; the text's size if there is none.
std::size_t find_end(std::string_view text, std::string_view ends) {
    int open = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (open == 0 && ends.find(c) != std::string_view::npos) return i;
        if (c == '\\') {
            ++i;
        } else if (c == '"' || c == '\'') {
            const std::size_t close = text.find(c, i + 1);
            if (close == std::string_view::npos) return text.size();
            i = close;
        } else if (c == '(' || c == '[' || c == '{') {
            ++open;
        } else if ((c == ')' || c == ']' || c == '}') && open > 0) {
            --open;
        }
    }
    return text.size();
}

std::vector<std::string_view> parts(std::string_view text, char separator) {
    std::vector<std::string_view> found;
    while (true) {
        const std::size_t end = find_end(text, std::string_view(&separator, 1));
        found.push_back(svg_trimmed(text.substr(0, end)));
        if (end >= text.size()) return found;
        text.remove_prefix(end + 1);
    }
}

/// Reads one selector; returns nothing if it is not understood.
class SelectorReader {
  public:
    explicit SelectorReader(std::string_view text) : rest_(svg_trimmed(text)) {}

    std::optional<CssSelector> read() {
        constexpr std::size_t longest = 10'000;  // beyond it, the specificity would overflow its fields
        CssSelector selector;
        if (rest_.size() > longest) return std::nullopt;
        while (!rest_.empty()) {
            CssCompound compound;
            compound.before = selector.compounds.empty() ? '\0' : combinator();
            if (!read_compound(compound)) return std::nullopt;
            selector.compounds.push_back(std::move(compound));
        }
        selector.specificity = specificity_;
        if (selector.compounds.empty()) return std::nullopt;
        return selector;
    }
    bool can_match() const { return can_match_; }

  private:
    char combinator() {
        char found = ' ';
        while (!rest_.empty() &&
               (is_css_blank(rest_.front()) || std::string_view(">+~").find(rest_.front()) != rest_.npos)) {
            if (!is_css_blank(rest_.front())) found = rest_.front();
            rest_.remove_prefix(1);
        }
        return found;
    }

    std::string name() {
        std::string found;
        while (!rest_.empty() && (is_letter_of_name(rest_.front()) || (rest_.front() == '\\' && rest_.size() > 1))) {
            if (rest_.front() == '\\')
                found += escaped();
            else
                found += take();
        }
        return found;
    }
    char take() {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        return c;
    }
    /// A CSS escape: `\31 ` is 1, `\.` a point. Escapes beyond ASCII are not supported; no program writes them.
    char escaped() {
        take();
        int code = 0, digits = 0;
        for (; digits < 6 && !rest_.empty() && std::isxdigit(static_cast<unsigned char>(rest_.front())); ++digits) {
            const char c = take();
            code = 16 * code + (c <= '9' ? c - '0' : (c | 32) - 'a' + 10);
        }
        if (digits == 0) return take();
        if (!rest_.empty() && is_css_blank(rest_.front())) take();
        return code > 0 && code < 128 ? static_cast<char>(code) : '?';
    }

    bool read_compound(CssCompound& compound) {
        bool is_any = false;
        while (!rest_.empty() && !is_css_blank(rest_.front()) &&
               std::string_view(">+~").find(rest_.front()) == rest_.npos) {
            if (!read_simple(compound)) return false;
            is_any = true;
        }
        return is_any;
    }

    bool read_simple(CssCompound& compound) {
        const char c = rest_.front();
        if (c == '*') {
            take();
        } else if (c == '|') {
            take();  // skips a namespace: elements are known by their local names
            compound.type.clear();
        } else if (c == '#' || c == '.') {
            take();
            const std::string found = name();
            if (found.empty()) return false;
            specificity_ += c == '#' ? 65536 : 256;
            if (c == '.')
                compound.classes.push_back(found);
            else if (!compound.id.empty() && compound.id != found)
                can_match_ = false;
            else
                compound.id = found;
        } else if (c == '[') {
            return read_attribute(compound);
        } else if (c == ':') {
            return read_place(compound);
        } else {
            compound.type = name();
            if (compound.type.empty()) return false;
            ++specificity_;
        }
        return true;
    }

    bool read_attribute(CssCompound& compound) {
        const std::size_t end = find_end(rest_.substr(1), "]");
        if (end + 1 >= rest_.size()) return false;
        const std::string_view inside = svg_trimmed(rest_.substr(1, end));
        rest_.remove_prefix(end + 2);
        specificity_ += 256;
        CssCompound::Attribute attribute;
        const std::size_t sign = inside.find('=');
        std::string_view key = inside.substr(0, sign);
        if (sign != std::string_view::npos) {
            std::string_view value = svg_trimmed(inside.substr(sign + 1));
            attribute.test = '=';
            if (!key.empty() && std::string_view("~|^$*").find(key.back()) != std::string_view::npos) {
                attribute.test = key.back();
                key.remove_suffix(1);
            }
            if (value.size() > 1 && (value[0] == '"' || value[0] == '\'')) {
                if (value.back() != value[0]) return false;  // `"a" i`
                value = value.substr(1, value.size() - 2);
            }
            attribute.value = value;
        }
        attribute.name = svg_trimmed(key);
        compound.attributes.push_back(std::move(attribute));
        return true;
    }

    bool read_place(CssCompound& compound) {
        static const std::set<std::string_view> known{"root", "first-child", "last-child", "only-child"};
        static const std::set<std::string_view> never{"hover",  "active",       "focus",         "visited",
                                                      "target", "link",         "focus-visible", "before",
                                                      "after",  "focus-within", "any-link"};
        take();
        if (!rest_.empty() && rest_.front() == ':') take();
        const std::string found = lower_case(name());
        if (!rest_.empty() && rest_.front() == '(') return false;
        specificity_ += 256;
        if (never.contains(found)) {
            can_match_ = can_match_ && (found == "link" || found == "any-link");
            return found != "link" && found != "any-link";
        }
        compound.places.push_back(found);
        return known.contains(found);
    }

    std::string_view rest_;
    int specificity_ = 0;
    bool can_match_ = true;
};

class SheetReader {
  public:
    void read(std::string_view rest, const std::string& doubt, int depth) {
        while (!(rest = svg_trimmed(rest)).empty()) {
            for (const std::string_view mark : {"<!--", "-->", "}"})
                if (rest.starts_with(mark)) rest.remove_prefix(mark.size());
            const std::size_t end = find_end(rest, "{;");
            const std::string_view head = svg_trimmed(rest.substr(0, end));
            std::string_view block;
            if (end < rest.size() && rest[end] == '{') {
                const std::size_t close = find_end(rest.substr(end + 1), "}");
                block = rest.substr(end + 1, close);
                rest.remove_prefix(std::min(rest.size(), end + 1 + close + 1));
            } else {
                rest.remove_prefix(std::min(rest.size(), end + 1));
            }
            if (head.starts_with('@'))
                read_at(head, block, doubt, depth);
            else if (!block.empty())
                add(head, block, doubt, depth);
        }
    }

    std::vector<CssRule> rules;

  private:
    void read_at(std::string_view head, std::string_view block, const std::string& doubt, int depth) {
        const std::string text = lower_case(head);
        std::string_view rest = text;
        const std::string_view name = svg_next_word(rest);
        const std::string_view condition = svg_trimmed(rest);
        if (name == "@import") {
            rules.push_back({{}, {}, readable_name(head)});
        } else if (name == "@media" || name == "@supports" || name == "@layer" || name == "@container") {
            if (depth > deepest_rules) return;
            bool is_all = name == "@media" && condition.empty(), is_other = name == "@media" && !condition.empty();
            for (const std::string_view medium : parts(condition, ',')) {
                if (medium == "all" || medium == "screen" || medium == "only screen" || medium == "only all")
                    is_all = is_all || name == "@media";
                if (medium != "print" && medium != "speech" && medium != "only print") is_other = false;
            }
            if (is_other && !is_all) return;
            read(block, is_all ? doubt : readable_name(head), depth + 1);
        }
    }

    void add(std::string_view head, std::string_view block, const std::string& doubt, int depth) {
        if (block.find('{') != std::string_view::npos && depth < deepest_rules)
            read(block, readable_name(head) + " with rules in it", depth + 1);
        CssRule rule{{}, css_declarations(block), doubt};
        for (const std::string_view part : parts(head, ',')) {
            SelectorReader reader(part);
            std::optional<CssSelector> selector = reader.read();
            if (!selector)
                rule.doubt = readable_name(part);
            else if (reader.can_match())
                rule.selectors.push_back(std::move(*selector));
        }
        rules.push_back(std::move(rule));
    }
};

}  // namespace

std::vector<CssDeclaration> css_declarations(std::string_view block) {
    std::vector<CssDeclaration> found;
    const std::string bare = without_comments(block);
    for (const std::string_view part : parts(bare, ';')) {
        const std::size_t colon = part.find(':');
        if (colon == std::string_view::npos) continue;
        CssDeclaration declaration{lower_case(svg_trimmed(part.substr(0, colon))), {}, false};
        std::string_view value = svg_trimmed(part.substr(colon + 1));
        const std::size_t mark = value.rfind('!');
        if (mark != std::string_view::npos && lower_case(svg_trimmed(value.substr(mark + 1))) == "important") {
            declaration.is_important = true;
            value = svg_trimmed(value.substr(0, mark));
        }
        declaration.value = value;
        found.push_back(std::move(declaration));
    }
    return found;
}

std::vector<CssRule> css_rules(std::string_view sheet) {
    const std::string bare = without_comments(sheet);
    SheetReader reader;
    reader.read(bare, "", 0);
    return std::move(reader.rules);
}

}  // namespace ripstop
