#include <algorithm>

#include "core/Dictionary.h"
#include "core/dictionary/Printer.h"
#include "core/dictionary/ValueReader.h"

namespace mpsDem {

using dictionary::Entry;
using dictionary::ValueReader;

namespace {

/// The plain entry that `key` finds; a missing one and a dictionary are refused.
Entry const& plainEntry(Dictionary::Node& node, std::string const& key)
{
    node.asked.insert(key);
    Entry const* const entry = node.find(key);
    Location missing = node.where();
    missing.entry = node.scoped(key);
    require(entry != nullptr, missing, "the entry \"" + key + "\" is missing", dictionary::didYouMean(key, node.keys()));
    require(!entry->dict, node.where(*entry), key + " must be a value, not a dictionary", key + " ...;");
    return *entry;
}

template <class T>
inline constexpr bool isList = false;
template <class T>
inline constexpr bool isList<std::vector<T>> = true;

template <class T>
T valueOf(Dictionary::Node& node, std::string const& key)
{
    Entry const& entry = plainEntry(node, key);
    ValueReader reader(entry, node.where(entry));
    if constexpr (!isList<T>) reader.skipUniform();
    T value;
    reader.take(value);
    reader.finish();
    return value;
}

template <class T>
T dimensioned(Dictionary::Node& node, std::string const& key, std::vector<int> const& dimensions)
{
    Entry const& entry = plainEntry(node, key);
    ValueReader reader(entry, node.where(entry));
    reader.takeDimensions(dimensions);
    T value;
    reader.take(value);
    reader.finish();
    return value;
}

std::string text(Real value)
{
    dictionary::Token token;
    token.kind = dictionary::TokenKind::Number;
    token.number = value;
    return dictionary::numberText(token);
}

} // namespace

template <class T>
T Dictionary::get(std::string const& key) const
{
    return valueOf<T>(*node_, key);
}

template bool Dictionary::get<bool>(std::string const&) const;
template int Dictionary::get<int>(std::string const&) const;
template std::int64_t Dictionary::get<std::int64_t>(std::string const&) const;
template Real Dictionary::get<Real>(std::string const&) const;
template std::string Dictionary::get<std::string>(std::string const&) const;
template Vector Dictionary::get<Vector>(std::string const&) const;
template Tensor Dictionary::get<Tensor>(std::string const&) const;
template std::vector<Real> Dictionary::get<std::vector<Real>>(std::string const&) const;
template std::vector<int> Dictionary::get<std::vector<int>>(std::string const&) const;
template std::vector<std::string> Dictionary::get<std::vector<std::string>>(std::string const&) const;
template std::vector<Vector> Dictionary::get<std::vector<Vector>>(std::string const&) const;
template std::vector<std::vector<int>> Dictionary::get<std::vector<std::vector<int>>>(std::string const&) const;

Real Dictionary::getDimensioned(std::string const& key, std::vector<int> const& dimensions) const
{
    return dimensioned<Real>(*node_, key, dimensions);
}

Vector Dictionary::getDimensionedVector(std::string const& key, std::vector<int> const& dimensions) const
{
    return dimensioned<Vector>(*node_, key, dimensions);
}

Real Dictionary::getInRange(std::string const& key, Real lowest, Real highest) const
{
    constexpr Real unbounded = 1e300;
    Real const value = get<Real>(key);
    bool const inside = value >= lowest && value <= highest;
    if (inside) return value;
    std::string range = "in [" + text(lowest) + ", " + text(highest) + "]";
    if (highest >= unbounded) range = "at least " + text(lowest);
    if (lowest <= -unbounded) range = "at most " + text(highest);
    throw CaseError(ExitCode::BadInput, where(key), key + " is " + text(value), "allowed: " + range);
}

Real Dictionary::getInRangeOr(std::string const& key, Real fallback, Real lowest, Real highest) const
{
    return found(key) ? getInRange(key, lowest, highest) : fallback;
}

std::string Dictionary::getWord(std::string const& key, std::vector<std::string> const& known, std::string const& plural) const
{
    auto const word = get<std::string>(key);
    bool const isKnown = std::find(known.begin(), known.end(), word) != known.end();
    std::string const cut = dictionary::shown(word);
    require(isKnown, where(key), key + " \"" + cut + "\" is not known", knownWords(plural, cut, known));
    return word;
}

std::string Dictionary::getWordOr(std::string const& key, std::string const& fallback, std::vector<std::string> const& known,
                                  std::string const& plural) const
{
    return found(key) ? getWord(key, known, plural) : fallback;
}

} // namespace mpsDem
