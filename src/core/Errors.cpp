#include "core/Errors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <vector>

namespace mpsDem {

std::string Location::str() const
{
    if (file.empty()) return {};
    return line > 0 ? file + ":" + std::to_string(line) : file;
}

namespace {

std::string message(Location const& where, std::string const& what, std::string const& allowed)
{
    std::string const place = where.str();
    std::string text = place.empty() ? what : place + ": " + what;
    if (!allowed.empty()) text += "\n    " + allowed;
    return text;
}

} // namespace

CaseError::CaseError(ExitCode code, Location where, std::string const& what, std::string const& allowed)
    : std::runtime_error(message(where, what, allowed)),
      code_(code),
      where_(std::move(where))
{}

CaseError::CaseError(ExitCode code, std::string const& what, std::string const& allowed) : CaseError(code, Location{}, what, allowed) {}

int editDistance(std::string const& a, std::string const& b)
{
    std::size_t const columns = b.size() + 1;
    std::vector<int> beforeLast(columns), last(columns), now(columns);
    for (std::size_t j = 0; j < columns; ++j) last[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        now[0] = static_cast<int>(i);
        for (std::size_t j = 1; j < columns; ++j)
        {
            int const change = a[i - 1] == b[j - 1] ? 0 : 1;
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + change});
            bool const swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) now[j] = std::min(now[j], beforeLast[j - 2] + 1);
        }
        std::swap(beforeLast, last);
        std::swap(last, now);
    }
    return last[columns - 1];
}

int wordDistance(std::string const& a, std::string const& b)
{
    if (a == b) return 0;
    auto const small = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return text;
    };
    std::string const first = small(a), second = small(b);
    int const edits = std::max(1, editDistance(first, second));
    bool const begins = std::min(a.size(), b.size()) >= 3 && (first.starts_with(second) || second.starts_with(first));
    return begins ? std::min(edits, 2) : edits;
}

std::string shortNumber(double value, int digits)
{
    std::array<char, 32> buffer{};
    auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits).ptr;
    return {buffer.data(), end};
}

} // namespace mpsDem
