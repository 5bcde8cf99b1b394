#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bodies/Entries.h"
#include "core/Dictionary.h"
#include "core/Types.h"

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
/// Reads the entry `key`; nothing is set where it is absent.
FieldValues readFieldValues(Dictionary const& dict, std::string const& key);

/// A vector that must be finite and, in 2-D, have no third component.
Vector readPoint(Dictionary const& dict, std::string const& key, int dimensions = 2);

/// A list of points of the x-y plane: vectors without third component.
std::vector<Vector> readPoints(Dictionary const& dict, std::string const& key);

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
