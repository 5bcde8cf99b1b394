#include "core/dictionary/Printer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace mpsDem::dictionary {

namespace {

constexpr std::array listTypes = {"bool", "label", "scalar", "vector", "sphericalTensor", "symmTensor", "tensor", "string", "word"};
constexpr std::size_t longestLine = 10; ///< Longer lists stand one value a line.

std::string quoted(std::string const& text)
{
    std::string out = "\"";
    bool escaped = false;
    for (char const c : text)
    {
        if (!escaped && (c == '"' || c == '\n')) out += '\\';
        escaped = !escaped && c == '\\';
        out += c;
    }
    return out + '"';
}

std::string tokenText(Token const& token)
{
    switch (token.kind)
    {
    case TokenKind::Integer:
    case TokenKind::Number:
        return numberText(token);
    case TokenKind::Text:
        return quoted(token.text);
    case TokenKind::Verbatim:
        return "#{" + token.text + "#}";
    case TokenKind::Variable:
        return "$" + token.text;
    case TokenKind::Directive:
        return "#" + token.text;
    default:
        return token.text;
    }
}

/// Reads `[N](a b c)` or `N{a}` behind a List<type> and says how OpenFOAM writes it.
class ListText
{
public:
    ListText(Tokens const& tokens, std::size_t begin) : tokens_(tokens), next_(begin + 1)
    {
        type_ = tokens[begin].text.substr(5, tokens[begin].text.size() - 6);
        if (next_ < tokens.size() && tokens[next_].kind == TokenKind::Integer) count_ = tokens[next_++].integer;
        valid_ = next_ < tokens.size() && tokens[next_].opens();
        if (valid_) readElements();
    }

    [[nodiscard]] bool valid() const { return valid_; }
    [[nodiscard]] std::size_t end() const { return next_; }

    [[nodiscard]] std::string str() const
    {
        std::string const count = std::to_string(size());
        bool const same = uniform_ || allSame();
        bool const contiguous = type_ != "word" && type_ != "string" && type_ != "bool";
        if (same && contiguous && size() > 1) return " " + count + "{" + elements_.front() + "}";
        bool const oneLine = size() <= 1 || (size() <= longestLine && type_ != "string");
        std::string text = oneLine ? " " + count + "(" : " \n" + count + "\n(\n";
        for (std::size_t i = 0; i < elements_.size(); ++i) text += (oneLine && i > 0 ? " " : "") + elements_[i] + (oneLine ? "" : "\n");
        return text + (oneLine ? ")" : ")\n");
    }

private:
    [[nodiscard]] std::size_t size() const { return uniform_ ? static_cast<std::size_t>(count_) : elements_.size(); }

    void readElements()
    {
        uniform_ = tokens_[next_].isPunctuation('{');
        int depth = 1;
        std::size_t const begin = next_ + 1;
        std::string element;
        for (++next_; next_ < tokens_.size() && depth > 0; ++next_)
        {
            Token const& token = tokens_[next_];
            if (token.closes() && --depth == 0) continue;
            bool const tight = element.empty() || element.back() == '(' || token.isPunctuation(')');
            element += (tight ? "" : " ") + text(token);
            if (token.opens()) ++depth;
            if (depth > 1) continue;
            elements_.push_back(std::move(element));
            element.clear();
        }
        valid_ = depth == 0;
        length_ = next_ - begin - (valid_ ? 1 : 0);
    }

    /// Compares values with all their digits, element by element.
    [[nodiscard]] bool allSame() const
    {
        std::size_t const begin = next_ - 1 - length_;
        std::size_t const period = elements_.empty() ? 1 : length_ / elements_.size();
        auto const same = [](Token const& a, Token const& b) {
            return a.kind == b.kind ? a.text == b.text && a.number == b.number : a.isNumber() && b.isNumber() && a.number == b.number;
        };
        for (std::size_t i = period; i < length_; ++i)
            if (!same(tokens_[begin + i], tokens_[begin + i - period])) return false;
        return true;
    }

    [[nodiscard]] std::string text(Token const& token) const
    {
        bool const asScalar = token.kind == TokenKind::Integer && type_ != "label" && type_ != "bool";
        if (asScalar)
        {
            Token scalar = token;
            scalar.kind = TokenKind::Number;
            return numberText(scalar);
        }
        if (type_ == "bool" && token.isName()) return token.isWord("true") || token.isWord("on") || token.isWord("yes") ? "1" : "0";
        return tokenText(token);
    }

    Tokens const& tokens_;
    std::size_t next_;
    std::string type_;
    std::vector<std::string> elements_;
    std::int64_t count_ = 0;
    std::size_t length_ = 0; ///< Tokens between the brackets.
    bool uniform_ = false;
    bool valid_ = false;
};

} // namespace

bool isListType(Token const& token)
{
    if (token.kind != TokenKind::Word || !token.text.starts_with("List<") || token.text.back() != '>') return false;
    std::string const type = token.text.substr(5, token.text.size() - 6);
    return std::find(listTypes.begin(), listTypes.end(), type) != listTypes.end();
}

std::string numberText(Token const& token)
{
    constexpr int precision = 6;
    std::array<char, 32> buffer{};
    if (token.number == 0) return "0";
    bool const label = token.kind == TokenKind::Integer && std::abs(token.number) <= std::numeric_limits<std::int32_t>::max();
    char *const begin = buffer.data(), *const end = begin + buffer.size();
    char* const last = label            ? std::to_chars(begin, end, token.integer).ptr
                       : token.computed ? std::to_chars(begin, end, token.number).ptr // shortest that reads back the same
                                        : std::to_chars(begin, end, token.number, std::chars_format::general, precision).ptr;
    return {begin, last};
}

std::string tokensText(Tokens const& tokens)
{
    std::string text;
    for (std::size_t i = 0; i < tokens.size();)
    {
        if (!text.empty()) text += ' ';
        text += tokenText(tokens[i]);
        if (isListType(tokens[i]))
        {
            ListText const list(tokens, i);
            if (list.valid())
            {
                text += list.str();
                i = list.end();
                continue;
            }
        }
        ++i;
    }
    return text;
}

std::string nodeText(Dictionary::Node const& node, int depth)
{
    std::string text;
    for (Entry const& entry : node.entries)
    {
        if (depth == 0 && !text.empty()) text += '\n';
        text += entryText(entry, depth);
    }
    return text;
}

std::vector<std::string> printedKeys(Dictionary::Node const& node)
{
    std::vector<std::string> keys;
    for (Entry const& entry : node.entries) keys.push_back(entry.quoted ? quoted(entry.key) : entry.key);
    return keys;
}

std::string entryText(Entry const& entry, int depth)
{
    constexpr std::size_t valueColumn = 16;
    std::string const indent(static_cast<std::size_t>(4 * depth), ' ');
    std::string const key = entry.quoted ? quoted(entry.key) : entry.key;
    if (entry.dict) return indent + key + '\n' + indent + "{\n" + nodeText(*entry.dict, depth + 1) + indent + "}\n";
    std::size_t const gap = key.size() < valueColumn ? valueColumn - key.size() : 1;
    return indent + key + std::string(gap, ' ') + tokensText(entry.tokens) + ";\n";
}

} // namespace mpsDem::dictionary
