#include "io/StlText.h"

#include <string>

#include "io/TextWords.h"

namespace mpsDem {

namespace {

class Reader
{
public:
    Reader(std::string_view text, FacetSoup& soup) : words_(text), soup_(soup) {}

    void run()
    {
        soup_.solids = 0;
        for (words_.next(); !words_.done(); words_.next())
        {
            want("solid");
            ++soup_.solids;
            words_.skipLine();
            for (words_.next(); words_.is("facet"); words_.next()) readFacet();
            want("endsolid");
            words_.skipLine();
        }
    }

private:
    [[noreturn]] void fail(std::string const& allowed) const
    {
        Location where = soup_.file;
        where.line = words_.line();
        throw CaseError(ExitCode::BadInput, where, words_.shown() + " in facet " + std::to_string(soup_.facets.size() + 1), allowed);
    }

    void want(std::string_view word) const
    {
        if (!words_.is(word)) fail(std::string(word) + (words_.done() ? "; the file is cut off" : ""));
    }

    void wantNext(std::string_view word)
    {
        words_.next();
        want(word);
    }

    Real number()
    {
        words_.next();
        auto const value = words_.number();
        if (!value) fail("a number");
        return *value;
    }

    void readFacet()
    {
        int const line = words_.line();
        wantNext("normal");
        for (int k = 0; k < 3; ++k) words_.next();
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

    TextWords words_;
    FacetSoup& soup_;
};

} // namespace

bool startsAsStlText(std::string_view text)
{
    TextWords words(text);
    words.next();
    return words.is("solid");
}

void readStlText(std::string_view text, FacetSoup& soup) { Reader(text, soup).run(); }

} // namespace mpsDem
