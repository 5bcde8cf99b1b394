#include "scene/EntryText.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/Errors.h"
#include "core/OnceLog.h"

namespace mpsDem {

namespace {

/// Reads numbers and parentheses one after the other and refuses anything else.
class TokenReader
{
public:
    TokenReader(Dictionary const& dict, std::string const& key, std::string allowed)
        : tokens_(dict.entryTokens(key)),
          where_(dict.where(key)),
          key_(key),
          allowed_(std::move(allowed))
    {}

    [[nodiscard]] bool done() const { return next_ == tokens_.size(); }
    [[nodiscard]] bool at(std::string const& token) const { return !done() && tokens_[next_] == token; }
    std::string take()
    {
        if (done()) fail("it ends too early");
        return tokens_[next_++];
    }
    void take(std::string const& token)
    {
        std::string const found = take();
        if (found != token) fail("\"" + found + "\" stands where " + token + " is expected");
    }
    Real number()
    {
        std::string const text = take();
        Real value = 0;
        auto const result = std::from_chars(text.data(), text.data() + text.size(), value);
        if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || !std::isfinite(value))
            fail("\"" + text + "\" is no number");
        return value;
    }
    Vector vector()
    {
        take("(");
        Vector v;
        for (int d = 0; d < 3; ++d) v[d] = number();
        take(")");
        return v;
    }
    void finish()
    {
        if (!done()) fail("\"" + tokens_[next_] + "\" stands behind its end");
    }
    [[noreturn]] void fail(std::string const& what) const { throw CaseError(ExitCode::BadInput, where_, key_ + ": " + what, allowed_); }

private:
    std::vector<std::string> tokens_;
    std::size_t next_ = 0;
    Location where_;
    std::string key_, allowed_;
};

std::string const toSpace = "dimensions 3 in constant/particleProperties";

std::string listed(std::vector<std::string> const& words)
{
    std::string text;
    for (std::string const& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

void requireInPlane(Vector const& r, Location const& where, std::string const& key)
{
    require(r.allFinite(), where, key + " is not finite", "three numbers");
    require(r.z() == 0, where, key + " leaves the x-y plane", "a 2-D case lies in the plane z = 0; or " + toSpace);
}

} // namespace

std::vector<Vector> readVectorSequence(Dictionary const& dict, std::string const& key, std::size_t count)
{
    TokenReader reader(dict, key, std::to_string(count) + " vectors side by side: " + key + " (x y z) (x y z);");
    std::vector<Vector> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(reader.vector());
    reader.finish();
    return values;
}

bool isWord(Dictionary const& dict, std::string const& key, std::string const& word)
{
    return dict.found(key) && dict.entryTokens(key) == std::vector<std::string>{word};
}

FieldValues readFieldValues(Dictionary const& dict, std::string const& key, int dimensions)
{
    FieldValues values;
    if (!dict.found(key)) return values;
    TokenReader reader(dict, key, "( volVectorFieldValue U (1 0 0) volScalarFieldValue p 0 ), either of them or none");
    reader.take("(");
    while (!reader.at(")"))
    {
        std::string const kind = reader.take();
        std::vector<std::string> const kinds{"volScalarFieldValue", "volVectorFieldValue"};
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            throw CaseError(ExitCode::BadInput, dict.where(key), key + ": kind of value \"" + kind + "\" is not known",
                            knownWords("kinds", kind, kinds));
        std::string const field = reader.take();
        bool const vectorial = kind == kinds[1];
        if (field != (vectorial ? "U" : "p"))
            reader.fail("particles have no " + std::string(vectorial ? "vector" : "scalar") + " field \"" + field + "\" to be set");
        if (vectorial)
        {
            values.velocity = reader.vector();
            values.hasVelocity = true;
        }
        else
        {
            values.pressure = reader.number();
            values.hasPressure = true;
        }
    }
    reader.take(")");
    reader.finish();
    if (dimensions == 2) requireInPlane(values.velocity, dict.where(key), "U");
    return values;
}

void refuseInPlane(Dictionary const& dict, std::initializer_list<char const*> keys)
{
    for (char const* key : keys)
        require(!dict.found(key), dict.where(key), std::string(key) + " in a case of two dimensions", "leave it out, or " + toSpace);
}

void refuseInPlane(Location const& where, std::string const& kind, std::string const& word, std::vector<std::string> const& plane,
                   std::vector<std::string> const& space)
{
    auto const among = [&](std::vector<std::string> const& words) { return std::find(words.begin(), words.end(), word) != words.end(); };
    require(among(plane) || !among(space), where, kind + " \"" + word + "\" in a case of two dimensions",
            toSpace + "; or one of: " + listed(plane));
}

void requireBoxInSpace(Vector const& min, Vector const& max, Location const& where)
{
    bool const flat = min.z() == max.z() && min.x() < max.x() && min.y() < max.y();
    require(!flat, where, "a box without extent in z", "min < max in x, y and z; or dimensions 2 in constant/particleProperties");
    require((min.array() < max.array()).all(), where, "a box whose max is not above its min", "min < max in x, y and z");
}

void warnOfDepth(Location const& where, std::string const& what, Real depth, Lattice const& lattice, bool more)
{
    if (!(depth > 0) || std::abs(depth - lattice.thickness) <= 1e-6 * lattice.thickness) return;
    if (more && depth > lattice.thickness) return;
    warnOnce(where.str() + ": " + what + " reaches over " + shortNumber(depth) +
             " m in z, which does not count in a case of two dimensions; " + "its thickness is " + shortNumber(lattice.thickness) +
             " m: is dimensions 3 or another thickness meant" + " (constant/particleProperties)?");
}

Vector readPoint(Dictionary const& dict, std::string const& key, int dimensions)
{
    Vector const r = dict.get<Vector>(key);
    require(r.allFinite(), dict.where(key), key + " is not finite", "three numbers");
    if (dimensions == 2) requireInPlane(r, dict.where(key), key);
    return r;
}

std::vector<Vector> readPoints(Dictionary const& dict, std::string const& key)
{
    auto points = dict.get<std::vector<Vector>>(key);
    for (Vector const& r : points) requireInPlane(r, dict.where(key), key);
    return points;
}

} // namespace mpsDem
