#pragma once

#include <string>
#include <vector>

#include "core/dictionary/Node.h"

namespace mpsDem::dictionary {

/// Exponents of dimensions as they are written: "[1 -3 0 0 0 0 0]".
std::string dimensionsText(std::vector<int> const& exponents);

/// Takes typed values from the tokens of one entry, front to back. Every function throws CaseError where the tokens don't fit.
class ValueReader
{
public:
    /// @param entry  Must outlive the reader. @param where  Place that messages name.
    ValueReader(Entry const& entry, Location where) : entry_(entry), where_(std::move(where)) {}

    void take(bool& value);
    void take(int& value);
    void take(std::int64_t& value);
    void take(Real& value);
    void take(std::string& value);
    void take(Vector& value);
    void take(Tensor& value);

    /// `(a b)`, `2(a b)`, `2{a}`, `()`, `List<type> 2(a b)`, `nonuniform ...`; `uniform a` gives one value.
    template <class T>
    void take(std::vector<T>& values);

    /// Skips the word `uniform` before a single value.
    void skipUniform();
    /// Takes `name [0 2 -1 0 0 0 0]` or `[...]` before a value where it stands there, and compares the exponents.
    void takeDimensions(std::vector<int> const& expected);
    /// Refuses what is left.
    void finish() const;

private:
    [[nodiscard]] bool atEnd() const { return next_ >= entry_.tokens.size(); }
    [[nodiscard]] bool sees(char punctuation) const { return !atEnd() && entry_.tokens[next_].isPunctuation(punctuation); }
    [[nodiscard]] bool seesWord(char const* word) const { return !atEnd() && entry_.tokens[next_].isWord(word); }
    /// Whether `[` or `name [` comes next.
    [[nodiscard]] bool seesDimensions() const { return sees('[') || seesNameOfDimensions(); }
    [[nodiscard]] bool seesNameOfDimensions() const;
    [[nodiscard]] std::string found() const;
    [[nodiscard]] Location here() const;
    Token const& expectToken(bool fits, std::string const& what);
    void expectPunctuation(char punctuation);
    void takeNumbers(Real* values, int count, std::string const& what);
    [[nodiscard]] std::int64_t integerWithin(Real lowest, Real highest);

    Entry const& entry_;
    Location where_;
    std::size_t next_ = 0;
};

template <class T>
void ValueReader::take(std::vector<T>& values)
{
    values.clear();
    if (seesWord("uniform"))
    {
        ++next_;
        take(values.emplace_back());
        return;
    }
    if (seesWord("nonuniform")) ++next_;
    bool const typed = !atEnd() && entry_.tokens[next_].kind == TokenKind::Word && entry_.tokens[next_].text.starts_with("List<");
    if (typed) ++next_;
    bool const counted = !atEnd() && entry_.tokens[next_].kind == TokenKind::Integer;
    std::int64_t const count = counted ? integerWithin(0, 8388608) : 0;
    if (counted && sees('{'))
    {
        ++next_;
        T value;
        take(value);
        expectPunctuation('}');
        values.assign(static_cast<std::size_t>(count), value);
        return;
    }
    expectPunctuation('(');
    while (!atEnd() && !sees(')'))
    {
        T value;
        take(value);
        values.push_back(std::move(value));
    }
    expectPunctuation(')');
    bool const right = !counted || count == static_cast<std::int64_t>(values.size());
    require(right, where_, "the list holds " + std::to_string(values.size()) + " values, not " + std::to_string(count));
}

} // namespace mpsDem::dictionary
