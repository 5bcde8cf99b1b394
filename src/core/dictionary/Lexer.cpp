#include "core/dictionary/Lexer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/dictionary/Limits.h"

namespace mpsDem::dictionary {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isNumberCharacter(char c) { return isDigit(c) || c == '.' || c == '+' || c == '-' || c == 'e' || c == 'E'; }
bool isWordCharacter(char c) { return !isBlank(c) && c != '"' && c != '\'' && c != '/' && c != ';' && c != '{' && c != '}' && c != '\0'; }
bool isPunctuation(char c) { return std::string_view("(){}[];:,=+-*/").find(c) != std::string_view::npos; }

/// Text as the rest of the program wants it: no byte order mark, lines ended by LF alone.
std::string normalised(std::string text)
{
    bool const marked = text.size() >= 3 && text[0] == '\xEF' && text[1] == '\xBB' && text[2] == '\xBF';
    if (marked) text.erase(0, 3);
    if (text.find('\r') == std::string::npos) return text;
    std::string unixText;
    unixText.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        bool const pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
        if (!pair) unixText += text[i];
    }
    return unixText;
}

} // namespace

std::string shown(std::string const& text)
{
    constexpr std::size_t longest = 60;
    std::string cut = text.substr(0, longest);
    std::replace_if(
        cut.begin(), cut.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return text.size() > longest ? cut + "..." : cut;
}

std::string nearestName(std::string const& word, std::vector<std::string> const& known)
{
    constexpr std::size_t longest = 100;
    constexpr std::size_t most = 1000;
    if (word.size() > longest || known.size() > most) return {};
    std::vector<std::string> candidates;
    std::copy_if(known.begin(), known.end(), std::back_inserter(candidates), [](auto const& name) { return name.size() <= longest; });
    return nearestWord(word, candidates);
}

std::string didYouMean(std::string const& word, std::vector<std::string> const& known)
{
    std::string const near = nearestName(word, known);
    return near.empty() ? std::string() : "(did you mean " + near + "?)";
}

Lexer::Lexer(std::string text, std::string name, bool lenient)
    : text_(normalised(std::move(text))),
      name_(std::make_shared<std::string const>(std::move(name))),
      lenient_(lenient)
{
    auto const isControl = [](char c) { return (static_cast<unsigned char>(c) < ' ' && !isBlank(c)) || c == '\x7f'; };
    auto const bad = std::find_if(text_.begin(), text_.end(), isControl);
    if (bad == text_.end()) return;
    int const line = 1 + static_cast<int>(std::count(text_.begin(), bad, '\n'));
    require(false, where(line), "holds a control character (byte " + std::to_string(static_cast<int>(*bad)) + "): it is no text file");
}

Token Lexer::next()
{
    if (!hasPeeked_) return read();
    hasPeeked_ = false;
    return std::move(peeked_);
}

Token const& Lexer::peek()
{
    if (!hasPeeked_) peeked_ = read();
    hasPeeked_ = true;
    return peeked_;
}

void Lexer::skipComment()
{
    int const begin = line_;
    if (ahead(1) == '/')
    {
        position_ = std::min(text_.find('\n', position_), text_.size());
        return;
    }
    std::size_t const end = text_.find("*/", position_ + 2);
    require(end != std::string::npos, where(begin), "the comment /* that begins here is not closed by */");
    line_ += static_cast<int>(
        std::count(text_.begin() + static_cast<std::ptrdiff_t>(position_), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    position_ = end + 2;
}

bool Lexer::skipBlanks()
{
    std::size_t const begin = position_;
    for (;;)
    {
        char const c = ahead(0);
        if (c == '/' && (ahead(1) == '/' || ahead(1) == '*'))
        {
            skipComment();
            continue;
        }
        if (!isBlank(c)) return position_ != begin;
        if (c == '\n') ++line_;
        ++position_;
    }
}

bool Lexer::startsNumber() const
{
    char const c = ahead(0);
    if (isDigit(c)) return true;
    if (c == '.') return isDigit(ahead(1));
    return c == '-' && (isDigit(ahead(1)) || (ahead(1) == '.' && isDigit(ahead(2))));
}

Token Lexer::read()
{
    Token token;
    token.glued = !skipBlanks();
    token.line = line_;
    if (position_ >= text_.size()) return token;
    char const c = ahead(0);
    if (c == '"')
        readText(token);
    else if (c == '#' && ahead(1) == '{')
        readVerbatim(token);
    else if (c == '$')
        readVariable(token);
    else if (c == '#')
    {
        ++position_;
        token.kind = TokenKind::Directive;
        if (isWordCharacter(ahead(0))) token.text = readWord("directive");
    }
    else if (startsNumber())
        readNumber(token);
    else if (isPunctuation(c))
    {
        token.kind = TokenKind::Punctuation;
        token.text.assign(1, c);
        ++position_;
    }
    else
    {
        require(isWordCharacter(c), where(line_), std::string("the character ") + c + " is not allowed here",
                "texts stand in double quotes");
        token.kind = TokenKind::Word;
        token.text = readWord("word");
    }
    return token;
}

std::string Lexer::readWord(char const* kind)
{
    std::size_t const begin = position_;
    int depth = 0;
    for (; isWordCharacter(ahead(0)); ++position_)
    {
        if (ahead(0) == '(') ++depth;
        if (ahead(0) == ')' && --depth < 0) break;
    }
    std::string word = text_.substr(begin, position_ - begin);
    require(depth <= 0, where(line_), std::string("the ") + kind + " \"" + shown(word) + "\" has a '(' without its ')'",
            "within a word there may be no blank; before a list there must be one");
    require(word.size() <= maxWordLength, where(line_),
            std::string("the ") + kind + " \"" + shown(word) + "\" is longer than 1024 characters");
    return word;
}

void Lexer::readText(Token& token)
{
    token.kind = TokenKind::Text;
    for (++position_; position_ < text_.size(); ++position_)
    {
        char const c = ahead(0);
        if (c == '"')
        {
            ++position_;
            return;
        }
        require(c != '\n', where(token.line), "the string that begins here is not closed by \" on its line: \"" + shown(token.text));
        bool const escaped = c == '\\' && position_ + 1 < text_.size();
        if (escaped)
        {
            ++position_;
            if (ahead(0) == '\n') ++line_;
            if (ahead(0) != '"' && ahead(0) != '\n') token.text += c;
        }
        token.text += ahead(0);
    }
    require(false, where(token.line), "the string that begins here is not closed by \": \"" + shown(token.text));
}

void Lexer::readVerbatim(Token& token)
{
    token.kind = TokenKind::Verbatim;
    std::size_t const end = text_.find("#}", position_ + 2);
    require(end != std::string::npos, where(token.line), "the text #{ that begins here is not closed by #}");
    token.text = text_.substr(position_ + 2, end - position_ - 2);
    line_ += static_cast<int>(std::count(token.text.begin(), token.text.end(), '\n'));
    position_ = end + 2;
}

void Lexer::readVariable(Token& token)
{
    token.kind = TokenKind::Variable;
    ++position_;
    if (ahead(0) == '{')
    {
        ++position_;
        std::size_t const end = text_.find_first_of("}\n", position_);
        bool const closed = end != std::string::npos && text_[end] == '}';
        require(closed, where(token.line), "the macro ${ that begins here is not closed by } on its line");
        token.text = text_.substr(position_, end - position_);
        position_ = end + 1;
    }
    else
    {
        token.text = readWord("macro");
        while (ahead(0) == '/' && ahead(1) != '/' && ahead(1) != '*')
        {
            ++position_;
            token.text += '/' + readWord("macro");
        }
    }
    require(!token.text.empty() && token.text.size() <= maxWordLength, where(token.line), "a macro $ without a name");
}

void Lexer::readNumber(Token& token)
{
    char const* const begin = text_.data() + position_;
    char const* const textEnd = text_.data() + text_.size();
    char const* end = begin;
    bool whole = true;
    for (; end != textEnd && isNumberCharacter(*end); ++end) whole = whole && (isDigit(*end) || end == begin);
    position_ += static_cast<std::size_t>(end - begin);
    auto const runsOn = [](char c) { return isWordCharacter(c) && std::string_view("()[],*:=").find(c) == std::string_view::npos; };
    while (!lenient_ && end != textEnd && runsOn(*end)) ++end;
    token.kind = TokenKind::Number;
    auto const integer = std::from_chars(begin, end, token.integer);
    if (whole && integer.ec == std::errc() && integer.ptr == end)
    {
        token.kind = TokenKind::Integer;
        token.number = static_cast<Real>(token.integer);
        return;
    }
    auto const real = std::from_chars(begin, end, token.number);
    std::string const text = shown(std::string(begin, end));
    require(real.ptr == end, where(token.line), "\"" + text + "\" is neither a number nor a word",
            "decimal numbers such as 0.5 or -1e-6; words that begin with a digit stand in double quotes");
    if (real.ec == std::errc()) return;
    std::size_t const exponent = text.find_first_of("eE");
    bool const small = exponent != std::string::npos && exponent + 1 < text.size() && text[exponent + 1] == '-';
    require(small, where(token.line), "the number " + text + " is out of range", "numbers between -1.7e308 and 1.7e308");
    token.number = 0;
}

std::string Lexer::readBraced(int line)
{
    std::size_t const begin = position_;
    int depth = 1;
    for (; position_ < text_.size(); ++position_)
    {
        if (ahead(0) == '\n') ++line_;
        if (ahead(0) == '{') ++depth;
        if (ahead(0) == '}' && --depth == 0) return text_.substr(begin, position_++ - begin);
    }
    require(false, where(line), "the '{' that begins here is not closed by '}'");
    return {};
}

} // namespace mpsDem::dictionary
