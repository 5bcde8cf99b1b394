#include <algorithm>
#include <type_traits>

#include "core/Dictionary.h"
#include "core/dictionary/Missing.h"
#include "core/dictionary/ValueReader.h"

namespace mpsDem {

using dictionary::Entry;
using dictionary::ValueReader;

namespace {

/// The plain entry that `key` finds; a missing one and a dictionary are refused. @param form  Of its value, for the message.
Entry const& plainEntry(Dictionary::Node& node, std::string const& key, std::string const& form)
{
    node.asked.insert(key);
    Entry const* const entry = node.find(key);
    if (!entry) dictionary::refuseMissing(node, key, "entry", key + " " + form);
    require(!entry->dict, node.where(*entry), key + " must be a value, not a dictionary", key + " " + form);
    return *entry;
}

template <class T>
inline constexpr bool isList = false;
template <class T>
inline constexpr bool isList<std::vector<T>> = true;

/// How a value of the type is written.
template <class T>
constexpr char const* formOf()
{
    if constexpr (isList<T>) return "( ... );";
    if constexpr (std::is_same_v<T, bool>) return "<yes or no>;";
    if constexpr (std::is_integral_v<T>) return "<integer>;";
    if constexpr (std::is_same_v<T, Real>) return "<number>;";
    if constexpr (std::is_same_v<T, std::string>) return "<word>;";
    if constexpr (std::is_same_v<T, Vector>) return "(x y z);";
    return "(xx xy xz yx yy yz zx zy zz);";
}

template <class T>
T valueOf(Dictionary::Node& node, std::string const& key)
{
    Entry const& entry = plainEntry(node, key, formOf<T>());
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
    std::string const form = std::string(formOf<T>()) + "   dimensions may stand before it: " + dictionary::dimensionsText(dimensions);
    Entry const& entry = plainEntry(node, key, form);
    ValueReader reader(entry, node.where(entry));
    reader.takeDimensions(dimensions);
    T value;
    reader.take(value);
    reader.finish();
    return value;
}

std::string rangeText(Real lowest, Real highest)
{
    constexpr Real unbounded = 1e300;
    if (highest >= unbounded) return "at least " + shortNumber(lowest);
    if (lowest <= -unbounded) return "at most " + shortNumber(highest);
    return "in [" + shortNumber(lowest) + ", " + shortNumber(highest) + "]";
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
    std::string const range = rangeText(lowest, highest);
    if (!found(key)) dictionary::refuseMissing(*node_, key, "entry", key + " <number>;   " + range);
    Real const value = get<Real>(key);
    require(value >= lowest && value <= highest, where(key), key + " is " + shortNumber(value), "allowed: " + range);
    return value;
}

Real Dictionary::getInRangeOr(std::string const& key, Real fallback, Real lowest, Real highest) const
{
    return found(key) ? getInRange(key, lowest, highest) : fallback;
}

std::string Dictionary::getWord(std::string const& key, std::vector<std::string> const& known, std::string const& plural) const
{
    if (!found(key)) dictionary::refuseMissing(*node_, key, "entry", key + " <word>;   " + knownWords(plural, {}, known));
    require(!entryText(key).empty(), where(key), key + " has no value", knownWords(plural, {}, known));
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
