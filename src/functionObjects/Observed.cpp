#include "functionObjects/Observed.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/Errors.h"
#include "core/Log.h"
#include "core/OnceLog.h"
#include "parallel/Reduce.h"

namespace mpsDem {

namespace {

bool isPlain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '+' || c == '-' || c == '.';
}

/// Unit vectors square to `up` and to each other, in the plane where there is no third dimension; those of space where `up` is zero.
std::vector<Vector> axesSquareTo(Vector const& up, bool planar)
{
    if (up.isZero())
        return planar ? std::vector<Vector>{Vector::UnitX(), Vector::UnitY()}
                      : std::vector<Vector>{Vector::UnitX(), Vector::UnitY(), Vector::UnitZ()};
    if (planar) return {Vector(up.y(), -up.x(), 0)};
    Vector const first = up.unitOrthogonal();
    return {first, up.cross(first)};
}

} // namespace

std::string startTimeName(Real startTime) { return shortNumber(startTime); }

void requireFileName(std::string const& name, Location const& where)
{
    bool const plain = !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), isPlain);
    require(plain, where, "\"" + name + "\" cannot be the name of a file", "letters, digits and _ + - . are allowed, not . in front");
}

TableFile makeTable(RunContext const& context, std::string const& object, std::string const& file, std::vector<std::string> columns,
                    std::vector<std::string> header)
{
    TableFile::Options options;
    options.header = std::move(header);
    return {context.caseRoot, object, startTimeName(context.startTime), file, std::move(columns), std::move(options)};
}

void requireFluid(RunContext const& context, Dictionary const& dict)
{
    require(context.particles.fluid().size() > 0, dict.where(), "this function object watches fluid, but the case has none",
            "remove it, or give the case constant/transportProperties and a region of fluid");
}

std::vector<int> readBodies(RunContext const& context, Dictionary const& dict)
{
    require(!context.bodies.empty(), dict.where(), "this function object watches rigid bodies, but the case has none",
            "remove it, or give the case constant/rigidBodyProperties");
    std::vector<std::string> known;
    for (auto const& body : context.bodies) known.push_back(body->name());
    std::vector<int> numbers;
    for (std::string const& name : dict.getOr<std::vector<std::string>>("bodies", known))
    {
        auto const found = std::find(known.begin(), known.end(), name);
        require(found != known.end(), dict.where("bodies"), "there is no body \"" + name + "\"", knownWords("bodies", name, known));
        numbers.push_back(static_cast<int>(found - known.begin()));
    }
    require(!numbers.empty(), dict.where("bodies"), "bodies is an empty list", "at least one of the case's bodies, or no such entry");
    return numbers;
}

std::vector<int> readPatches(RunContext const& context, Dictionary const& dict, std::string const& key)
{
    std::vector<std::string> const& known = context.wallNames;
    std::vector<int> numbers;
    for (std::string const& name : dict.get<std::vector<std::string>>(key))
    {
        auto const found = std::find(known.begin(), known.end(), name);
        require(found != known.end(), dict.where(key), "there is no fixed surface \"" + name + "\"", knownWords("surfaces", name, known));
        numbers.push_back(static_cast<int>(found - known.begin()));
    }
    require(!numbers.empty(), dict.where(key), key + " is an empty list", "at least one fixed surface");
    return numbers;
}

Vector readUp(RunContext const& context, Dictionary const& dict)
{
    Vector const direction = dict.getOr<Vector>("direction", -context.gravity);
    require(direction.allFinite() && direction.norm() > 0, dict.where("direction"), "the direction of elevation is zero",
            "the key direction, where there is no gravity");
    bool const planar = context.particles.lattice().dimensions == 2;
    require(!planar || std::abs(direction.z()) < 1e-12 * direction.norm(), dict.where("direction"),
            "the direction of elevation leaves the x-y plane of a 2-D case", "a direction with z = 0");
    return direction.normalized();
}

std::vector<Vector> placesOf(RunContext const& context, Dictionary const& dict, std::string const& key, std::vector<Vector> places)
{
    bool const planar = context.particles.lattice().dimensions == 2;
    for (Vector& place : places)
    {
        require(place.allFinite(), dict.where(key), key + " is not finite", "points (x y z)");
        if (!planar || place.z() == 0) continue;
        infoOnce(dict.where(key).str() + ": z of " + key + " does not count in a case of two dimensions");
        place.z() = 0;
    }
    return places;
}

void warnOfPlacesOutside(RunContext const& context, Dictionary const& dict, std::string const& key, std::vector<Vector> const& places,
                         Vector const& up)
{
    ParticleSet const& particles = context.particles;
    bool const planar = particles.lattice().dimensions == 2;
    std::string outside;
    for (Vector const& axis : axesSquareTo(up, planar))
    {
        auto const coordinate = [&](int i) { return particles.r[i].dot(axis); };
        Real const low = minOver(particles.owned(), std::numeric_limits<Real>::max(), coordinate).value;
        Real const high = maxOver(particles.owned(), std::numeric_limits<Real>::lowest(), coordinate).value;
        for (Vector const& place : places)
        {
            bool const inside = place.dot(axis) >= low && place.dot(axis) <= high;
            if (!inside && outside.find(text(place)) == std::string::npos) outside += " " + text(place);
        }
    }
    if (outside.empty()) return;
    std::string const message = dict.where(key).str() + ": " + key + " of " + dict.name() + " outside of all walls and fluid:" + outside;
    warn(message, message, 1);
}

void addVectorColumns(std::vector<std::string>& columns, std::string const& name)
{
    for (char const axis : {'x', 'y', 'z'}) columns.push_back(name + axis);
}

void addVector(std::vector<Real>& values, Vector const& vector) { values.insert(values.end(), vector.data(), vector.data() + 3); }

void addNumbers(std::string& table, std::initializer_list<Real> values)
{
    char const* separator = "";
    for (Real const value : values)
    {
        std::array<char, 32> buffer{};
        auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 10).ptr;
        table += separator;
        table.append(buffer.data(), end);
        separator = " ";
    }
    table += '\n';
}

std::string text(Vector const& vector)
{
    Vector const plain = vector + Vector::Zero(); // makes -0 a 0
    return "(" + shortNumber(plain.x()) + " " + shortNumber(plain.y()) + " " + shortNumber(plain.z()) + ")";
}

Real fluidMass(RunContext const& context)
{
    return context.density * context.particles.lattice().particleVolume() * sumOverRanks(context.particles.fluid().size());
}

} // namespace mpsDem
