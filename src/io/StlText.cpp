#include "io/StlText.h"

#include <charconv>
#include <string>

namespace mpsDem {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\r\n\f\v";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same(std::string_view a, std::string_view word)
{
    if (a.size() != word.size()) return false;
    for (std::size_t k = 0; k < a.size(); ++k)
        if (lower(a[k]) != word[k]) return false;
    return true;
}

class Reader
{
public:
    Reader(std::string_view text, FacetSoup& soup) : rest_(text), soup_(soup)
    {
        if (rest_.starts_with(byteOrderMark)) rest_.remove_prefix(byteOrderMark.size());
    }

    void run()
    {
        for (next(); !word_.empty(); next())
        {
            want("solid");
            skipLine();
            for (next(); same(word_, "facet"); next()) readFacet();
            want("endsolid");
            skipLine();
        }
    }

private:
    [[noreturn]] void fail(std::string const& what, std::string const& allowed) const
    {
        Location where = soup_.file;
        where.line = wordLine_;
        throw CaseError(ExitCode::BadInput, where, what + " in facet " + std::to_string(soup_.facets.size() + 1), allowed);
    }

    void next()
    {
        std::size_t k = 0;
        while (k < rest_.size() && blanks.find(rest_[k]) != std::string_view::npos)
            if (rest_[k++] == '\n') ++line_;
        rest_.remove_prefix(k);
        std::size_t const end = std::min(rest_.find_first_of(blanks), rest_.size());
        word_ = rest_.substr(0, end);
        wordLine_ = line_;
        rest_.remove_prefix(end);
    }

    /// Leaves out the rest of the line: the name of a solid.
    void skipLine() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

    [[nodiscard]] std::string shown() const
    {
        if (word_.empty()) return "the file ends";
        std::string text = "\"";
        for (char const c : word_.substr(0, 30)) text += c >= ' ' && c <= '~' ? c : '?';
        return text + "\"";
    }

    void want(std::string_view word) const
    {
        if (!same(word_, word)) fail(shown(), std::string(word) + (word_.empty() ? "; the file is cut off" : ""));
    }

    void wantNext(std::string_view word)
    {
        next();
        want(word);
    }

    Real number()
    {
        next();
        std::string_view digits = word_;
        if (digits.starts_with('+')) digits.remove_prefix(1);
        Real value = 0;
        auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size()) fail(shown(), "a number");
        return value;
    }

    void readFacet()
    {
        int const line = wordLine_;
        wantNext("normal");
        for (int k = 0; k < 3; ++k) next();
        wantNext("outer");
        wantNext("loop");
        FacetSoup::Facet facet;
        for (Vector& r : facet)
        {
            wantNext("vertex");
            for (Real& coordinate : r) coordinate = number();
        }
        wantNext("endloop");
        wantNext("endfacet");
        soup_.facets.push_back(facet);
        soup_.lines.push_back(line);
    }

    std::string_view rest_, word_;
    FacetSoup& soup_;
    int line_ = 1, wordLine_ = 1;
};

} // namespace

bool startsAsStlText(std::string_view text)
{
    if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return same(text.substr(0, 5), "solid") && (text.size() == 5 || blanks.find(text[5]) != std::string_view::npos);
}

void readStlText(std::string_view text, FacetSoup& soup) { Reader(text, soup).run(); }

} // namespace mpsDem
