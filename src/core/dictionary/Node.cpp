#include "core/dictionary/Node.h"

#include <algorithm>
#include <charconv>

#include <regex.h>

#include "core/dictionary/Limits.h"

namespace mpsDem::dictionary {

namespace {

/// Number of copies that the counted repetitions {m,n} of a regular expression ask for: the compiled form grows with it.
long repetitions(std::string const& text)
{
    long product = 1;
    for (std::size_t open = text.find('{'); open != std::string::npos && product < 100000; open = text.find('{', open + 1))
    {
        long largest = 1;
        for (std::size_t i = open + 1; i < text.size() && text[i] != '}'; ++i)
        {
            long bound = 1;
            std::from_chars(text.data() + i, text.data() + text.size(), bound);
            largest = std::max(largest, bound);
        }
        product *= std::min(largest, 100000L);
    }
    return product;
}

} // namespace

Pattern::Pattern(std::string const& text, Location const& where)
{
    constexpr std::size_t longest = 200;
    constexpr long mostRepetitions = 500;
    bool const modest = text.size() <= longest && repetitions(text) <= mostRepetitions;
    require(modest, where, "the pattern \"" + shown(text) + "\" is too large",
            "patterns of up to 200 characters, repeated up to 500 times");
    bool const refersBack =
        std::adjacent_find(text.begin(), text.end(), [](char a, char b) { return a == '\\' && b >= '0' && b <= '9'; }) != text.end();
    require(!refersBack, where, "the pattern \"" + shown(text) + "\" refers back to a group, which is not supported");
    auto const release = [](void* expression) {
        regfree(static_cast<regex_t*>(expression));
        delete static_cast<regex_t*>(expression);
    };
    auto raw = std::make_unique<regex_t>();
    bool const anyCase = text.starts_with("(?i)");
    std::string const expression = "^(" + text.substr(anyCase ? 4 : 0) + ")$";
    int const status = regcomp(raw.get(), expression.c_str(), REG_EXTENDED | REG_NOSUB | (anyCase ? REG_ICASE : 0));
    require(status == 0, where, "\"" + shown(text) + "\" is no regular expression");
    compiled_ = std::shared_ptr<void>(raw.release(), release);
}

bool Pattern::matches(std::string const& word) const
{
    return regexec(static_cast<regex_t const*>(compiled_.get()), word.c_str(), 0, nullptr, 0) == 0;
}

} // namespace mpsDem::dictionary

namespace mpsDem {

using dictionary::Entry;

namespace {

Entry* findScopedFrom(Dictionary::Node const& node, std::string const& path, char separator, Dictionary::Node::Match match, int& steps)
{
    if (Entry* const entry = node.findExact(path)) return entry;
    for (std::size_t cut = path.find(separator); cut != std::string::npos && --steps > 0; cut = path.find(separator, cut + 1))
    {
        Entry const* const first = node.findExact(path.substr(0, cut));
        if (!first || !first->dict) continue;
        if (Entry* const entry = findScopedFrom(*first->dict, path.substr(cut + 1), separator, match, steps)) return entry;
    }
    return match == Dictionary::Node::Match::Pattern ? node.find(path) : nullptr;
}

} // namespace

Entry* Dictionary::Node::findExact(std::string const& key) const
{
    auto const found = exact.find(key);
    return found == exact.end() ? nullptr : &*found->second;
}

Entry* Dictionary::Node::find(std::string const& key) const
{
    if (Entry* const entry = findExact(key)) return entry;
    auto const last = std::find_if(patterns.rbegin(), patterns.rend(), [&](auto const& entry) { return entry->match->matches(key); });
    return last == patterns.rend() ? nullptr : &**last;
}

Entry* Dictionary::Node::findScoped(std::string const& path, char separator, Match match) const
{
    int steps = 1000;
    return findScopedFrom(*this, path, separator, match, steps);
}

Entry& Dictionary::Node::append(Entry entry)
{
    entries.push_back(std::move(entry));
    auto const place = std::prev(entries.end());
    exact[place->key] = place;
    if (place->match) patterns.push_back(place);
    return *place;
}

void Dictionary::Node::remove(std::string const& key)
{
    auto const found = exact.find(key);
    if (found == exact.end()) return;
    auto const place = found->second;
    if (place->match) patterns.erase(std::find(patterns.begin(), patterns.end(), place));
    exact.erase(found);
    entries.erase(place);
}

std::vector<std::string> Dictionary::Node::keys() const
{
    std::vector<std::string> all;
    for (Entry const& entry : entries) all.push_back(entry.key);
    return all;
}

} // namespace mpsDem
