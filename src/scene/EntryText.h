#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "bodies/Entries.h"
#include "core/Dictionary.h"
#include "core/Types.h"
#include "particles/Lattice.h"

namespace mpsDem {

/// Entries whose form is free in OpenFOAM and which therefore are taken apart here.

/// Vectors side by side, as in `box (0 0 0) (2 1 0);`. @throw CaseError unless there are `count`, each of three finite numbers.
std::vector<Vector> readVectorSequence(Dictionary const& dict, std::string const& key, std::size_t count);

/// True where the entry is the one word given (`thickness auto;`).
bool isWord(Dictionary const& dict, std::string const& key, std::string const& word);

/// What `fieldValues ( volVectorFieldValue U (1 0 0) volScalarFieldValue p 0 );` sets: name and value, a scalar in the first component.
/// @throw CaseError for an unknown kind, a field other than U and p, or one of the wrong kind.
struct FieldValues
{
    bool hasVelocity = false, hasPressure = false;
    Vector velocity = Vector::Zero(); ///< [m/s]
    Real pressure = 0;                ///< [Pa]
};
/// Reads the entry `key`; nothing is set where it is absent. In 2-D U must have no third component.
FieldValues readFieldValues(Dictionary const& dict, std::string const& key, int dimensions);

/// A vector that must be finite and, in 2-D, have no third component.
Vector readPoint(Dictionary const& dict, std::string const& key, int dimensions = 2);

/// A list of points of the x-y plane: vectors without third component.
std::vector<Vector> readPoints(Dictionary const& dict, std::string const& key);

/// Words that only a case of three dimensions has, found in one of two: refused with the place, and `dimensions 3` as the way out.
void refuseInPlane(Dictionary const& dict, std::initializer_list<char const*> keys);
/// The same for the word of a kind, such as "surface type". @param plane, space  Those of two and of three dimensions.
void refuseInPlane(Location const& where, std::string const& kind, std::string const& word, std::vector<std::string> const& plane,
                   std::vector<std::string> const& space);
/// Refuses corners of a box in space whose max is not above its min; one without extent in z may be that of a case of two dimensions.
void requireBoxInSpace(Vector const& min, Vector const& max, Location const& where);
/// Warns of a box in a case of two dimensions that reaches over another length in z than the case stands for: it may be meant for three.
/// @param more  Longer ones are usual: they are to reach out of the case.
void warnOfDepth(Location const& where, std::string const& what, Real depth, Lattice const& lattice, bool more);

/// Runs `make` and gives errors that carry no place the place given.
template <class Make>
auto atPlace(Location const& where, Make make)
{
    try
    {
        return make();
    }
    catch (CaseError const& error)
    {
        if (!error.where().file.empty() || where.file.empty()) throw;
        throw CaseError(error.code(), where, error.what());
    }
}

} // namespace mpsDem
