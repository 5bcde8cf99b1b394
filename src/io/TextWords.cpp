#include "io/TextWords.h"

#include <algorithm>
#include <charconv>

namespace mpsDem {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\r\n\f\v";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

TextWords::TextWords(std::string_view text) : rest_(text)
{
    if (rest_.starts_with(byteOrderMark)) rest_.remove_prefix(byteOrderMark.size());
}

void TextWords::next()
{
    std::size_t k = 0;
    while (k < rest_.size() && blanks.find(rest_[k]) != std::string_view::npos)
        if (rest_[k++] == '\n') ++line_;
    rest_.remove_prefix(k);
    std::size_t end = 0;
    while (end < rest_.size() && blanks.find(rest_[end]) == std::string_view::npos) ++end;
    word_ = rest_.substr(0, end);
    wordLine_ = line_;
    rest_.remove_prefix(end);
}

void TextWords::skipLine() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

bool TextWords::is(std::string_view lowerCase) const
{
    return std::equal(word_.begin(), word_.end(), lowerCase.begin(), lowerCase.end(), [](char a, char b) { return lower(a) == b; });
}

std::optional<Real> TextWords::number() const
{
    std::string_view digits = word_;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    Real value = 0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) return {};
    return value;
}

std::string TextWords::shown() const
{
    if (word_.empty()) return "the file ends";
    std::string text = "\"";
    for (char const c : word_.substr(0, 30)) text += c >= ' ' && c <= '~' ? c : '?';
    return text + "\"";
}

} // namespace mpsDem
