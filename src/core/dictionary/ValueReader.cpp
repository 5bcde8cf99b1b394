#include "core/dictionary/ValueReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/dictionary/Printer.h"

namespace mpsDem::dictionary {

std::string dimensionsText(std::vector<int> const& exponents)
{
    std::string text;
    for (int const exponent : exponents) text += (text.empty() ? "[" : " ") + std::to_string(exponent);
    return text + "]";
}

bool ValueReader::seesNameOfDimensions() const
{
    bool const word = !atEnd() && entry_.tokens[next_].kind == TokenKind::Word;
    return word && next_ + 1 < entry_.tokens.size() && entry_.tokens[next_ + 1].isPunctuation('[');
}

std::string ValueReader::found() const { return atEnd() ? std::string("nothing") : shown(tokensText({entry_.tokens[next_]})); }

Location ValueReader::here() const
{
    bool const placed = !atEnd() && entry_.tokens[next_].line > 0;
    return placed ? Location{where_.file, entry_.tokens[next_].line, where_.entry} : where_;
}

Token const& ValueReader::expectToken(bool fits, std::string const& what)
{
    if (!fits)
    {
        bool const notFinite = seesWord("nan") || seesWord("inf") || seesWord("NaN") || seesWord("Inf");
        bool const path = next_ > 0 && sees('/');
        std::string hint;
        if (notFinite) hint = "numbers are finite";
        if (path) hint = "names with a / stand in double quotes";
        require(false, here(), entry_.key + ": " + what + " is expected, not " + found(), hint);
    }
    return entry_.tokens[next_++];
}

void ValueReader::expectPunctuation(char punctuation)
{
    expectToken(sees(punctuation), punctuation == '(' ? "a list ( ... )" : std::string("'") + punctuation + "'");
}

void ValueReader::take(bool& value)
{
    constexpr std::array words = {"true", "on", "yes", "false", "off", "no"};
    bool const isWord = !atEnd() && entry_.tokens[next_].isName();
    auto const place =
        std::find_if(words.begin(), words.end(), [&](char const* word) { return isWord && entry_.tokens[next_].text == word; });
    expectToken(place != words.end(), "a switch (true on yes false off no)");
    value = place - words.begin() < 3;
}

std::int64_t ValueReader::integerWithin(Real lowest, Real highest)
{
    Token const& token = expectToken(!atEnd() && entry_.tokens[next_].isNumber(), "an integer");
    bool const whole = token.number == std::floor(token.number);
    bool const fits = whole && token.number >= lowest && token.number <= highest;
    require(fits, {where_.file, token.line, where_.entry},
            entry_.key + " is " + numberText(token) + (whole ? ", which is out of range" : ", but must be an integer"));
    return token.kind == TokenKind::Integer ? token.integer : static_cast<std::int64_t>(token.number);
}

void ValueReader::take(int& value)
{
    value = static_cast<int>(integerWithin(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

void ValueReader::take(std::int64_t& value)
{
    constexpr Real below = 9.2233720368547e18;
    value = integerWithin(-below, below);
}

void ValueReader::take(Real& value)
{
    bool const plus = sees('+') && next_ + 1 < entry_.tokens.size() && entry_.tokens[next_ + 1].isNumber();
    if (plus) ++next_;
    require(!seesDimensions(), here(), entry_.key + " takes no dimensions: it is a plain number in SI units", entry_.key + " <number>;");
    value = expectToken(!atEnd() && entry_.tokens[next_].isNumber(), "a number").number;
}

void ValueReader::take(std::string& value) { value = expectToken(!atEnd() && entry_.tokens[next_].isName(), "a word").text; }

void ValueReader::takeNumbers(Real* values, int count, std::string const& what)
{
    std::string const hint = entry_.key + ": " + what + " has " + std::to_string(count) + " numbers, not ";
    expectToken(sees('('), what);
    for (int i = 0; i < count; ++i)
    {
        require(!sees(')'), here(), hint + std::to_string(i), count == 3 && i == 2 ? "in 2-D too: z is 0" : "");
        take(values[i]);
    }
    require(atEnd() || !entry_.tokens[next_].isNumber(), here(), hint + "more");
    expectToken(sees(')'), "')' behind " + std::to_string(count) + " numbers");
}

void ValueReader::take(Vector& value) { takeNumbers(value.data(), 3, "a vector (x y z)"); }

void ValueReader::take(Tensor& value)
{
    std::array<Real, 9> rows{};
    takeNumbers(rows.data(), 9, "a tensor of 9 numbers");
    for (int i = 0; i < 9; ++i) value(i / 3, i % 3) = rows[static_cast<std::size_t>(i)];
}

void ValueReader::skipUniform()
{
    if (seesWord("uniform")) ++next_;
}

void ValueReader::takeDimensions(std::vector<int> const& expected)
{
    if (seesNameOfDimensions()) ++next_;
    if (!sees('[')) return;
    Location const where = here();
    std::vector<Real> given;
    for (++next_; !sees(']');)
        given.push_back(
            expectToken(!atEnd() && entry_.tokens[next_].isNumber(), "an exponent of the dimensions, as in [0 2 -1 0 0 0 0],").number);
    ++next_;
    require(given.size() == 7 || given.size() == 5, where,
            entry_.key + ": dimensions have 7 or 5 exponents, not " + std::to_string(given.size()));
    given.resize(7, 0);
    std::vector<Real> wanted(expected.begin(), expected.end());
    wanted.resize(7, 0);
    require(given == wanted, where, entry_.key + " has the wrong dimensions", "allowed: " + dimensionsText(expected) + " or none");
}

void ValueReader::finish() const
{
    if (atEnd()) return;
    Token const& excess = entry_.tokens[next_];
    std::string hint;
    int const valueLine = next_ > 0 ? entry_.tokens[next_ - 1].line : entry_.line;
    if (excess.line > valueLine)
        hint = "is a ';' missing at the end of line " + std::to_string(valueLine) + "?";
    else if (excess.isPunctuation('/'))
        hint = "names with a / stand in double quotes";
    require(false, where_,
            entry_.key + " has more than one value: " +
                shown(tokensText({entry_.tokens.begin(), std::min(entry_.tokens.end(), entry_.tokens.begin() + 8)})),
            hint);
}

} // namespace mpsDem::dictionary
