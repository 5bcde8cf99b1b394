#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/Types.h"

namespace mpsDem::dictionary {

enum class TokenKind : std::uint8_t
{
    End,         ///< End of the text.
    Punctuation, ///< One character of ( ) { } [ ] ; : , = + - * /
    Word,        ///< Bare word; may hold balanced parentheses: div(phi,U).
    Text,        ///< "..." without its quotes; \" is stored as ", \ before a line end as the line end.
    Verbatim,    ///< What stands between #{ and #}.
    Variable,    ///< $name or ${name}, without $ and braces.
    Directive,   ///< #name, without #.
    Integer,     ///< Fits 64 bits.
    Number       ///< Any other number.
};

/// Smallest piece of a dictionary.
struct Token
{
    std::string text;         ///< Empty for numbers.
    Real number = 0;          ///< Value of a Number or Integer.
    std::int64_t integer = 0; ///< Value of an Integer.
    int line = 0;             ///< Line on which it begins.
    TokenKind kind = TokenKind::End;
    bool glued = false;    ///< No blank stands between it and the token before.
    bool computed = false; ///< A result of #eval: it is printed with all its digits, for nobody wrote it with fewer.

    [[nodiscard]] bool isPunctuation(char c) const { return kind == TokenKind::Punctuation && text[0] == c; }
    [[nodiscard]] bool isWord(char const* word) const { return kind == TokenKind::Word && text == word; }
    [[nodiscard]] bool isName() const { return kind == TokenKind::Word || kind == TokenKind::Text; }
    [[nodiscard]] bool isNumber() const { return kind == TokenKind::Integer || kind == TokenKind::Number; }
    [[nodiscard]] bool opens() const { return isPunctuation('(') || isPunctuation('{'); }
    [[nodiscard]] bool closes() const { return isPunctuation(')') || isPunctuation('}'); }
};

using Tokens = std::vector<Token>;

/// A word or text cut to a length that fits a message.
std::string shown(std::string const& text);

/// As nearestWord, but gives up on words or sets of a size that no typing error explains.
std::string nearestName(std::string const& word, std::vector<std::string> const& known);

/// "(did you mean x?)" or empty.
std::string didYouMean(std::string const& word, std::vector<std::string> const& known);

} // namespace mpsDem::dictionary
