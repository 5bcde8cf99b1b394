#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"

namespace mpsDem {

/// Name of the folder for a run that starts at this time: six significant digits, as the log writes times.
std::string startTimeName(Real startTime);

/// Refuses a name that cannot be that of a file or folder: allowed are letters, digits and _ + - . , not `.` in front.
void requireFileName(std::string const& name, Location const& where);

/// Table <case>/postProcessing/<object>/<startTime>/<file>.dat.
TableFile makeTable(RunContext const& context, std::string const& object, std::string const& file, std::vector<std::string> columns,
                    std::vector<std::string> header);

/// @throw CaseError BadInput where the case has no fluid.
void requireFluid(RunContext const& context, Dictionary const& dict);

/// Numbers of the bodies that `bodies (...)` names; all where it is absent.
/// @throw CaseError BadInput for an unknown name and for a case without bodies.
std::vector<int> readBodies(RunContext const& context, Dictionary const& dict);

/// Numbers of the fixed surfaces that a list of names holds.
/// @throw CaseError BadInput for an unknown name, a missing and an empty list.
std::vector<int> readPatches(RunContext const& context, Dictionary const& dict, std::string const& key);

/// Unit vector against gravity, or the key `direction`.
/// @throw CaseError BadInput where both are zero, or where the direction leaves the plane of a 2-D case.
Vector readUp(RunContext const& context, Dictionary const& dict);

/// Places of a function object [m]. In a 2-D case their third component does not count: it is set to zero, and a note names the entry.
/// @throw CaseError BadInput for one that is not finite.
std::vector<Vector> placesOf(RunContext const& context, Dictionary const& dict, std::string const& key, std::vector<Vector> places);

/// Warns, once a run, of places that lie outside of the extent of all particles, of walls and fluid, in the x-y plane (3-D: in space).
/// @param key  Entry of `dict` that names the places. @param up  Direction along which a place does not count, a unit vector; or zero.
void warnOfPlacesOutside(RunContext const& context, Dictionary const& dict, std::string const& key, std::vector<Vector> const& places,
                         Vector const& up);

/// Appends name + "x", "y", "z".
void addVectorColumns(std::vector<std::string>& columns, std::string const& name);

/// Appends the three components.
void addVector(std::vector<Real>& values, Vector const& vector);

/// Appends a row of a table: numbers of ten digits parted by blanks, and a line end.
void addNumbers(std::string& table, std::initializer_list<Real> values);

/// "(0.1 0.2 0)".
std::string text(Vector const& vector);

/// Mass of all fluid of the run [kg].
Real fluidMass(RunContext const& context);

} // namespace mpsDem
