#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "core/Types.h"

namespace mpsDem::postGauges {

/// The number with up to `digits` significant digits, shortest form: "0.75", "1e-06".
std::string number(Real value, int digits = 6);

/// With a fixed number of decimals: "0.750".
std::string fixedNumber(Real value, int decimals);

/// Fewest decimals (at least `lowest`, at most 9) by which all numbers differ in their fixed form.
int decimalsThatDiffer(std::vector<Real> const& values, int lowest);

/// One line of a table: numbers parted by blanks, ten digits, a line end. NaN as "nan", which gnuplot and readTable take.
void addRow(std::string& table, std::initializer_list<Real> values);
void addRow(std::string& table, std::vector<Real> const& values);

/// A gnuplot string in single quotes: no macro, no command and no escape is looked for within. Line ends become blanks.
std::string quoted(std::string const& text);

/// The text with gnuplot's signs for subscripts and such (_ ^ { } @ & ~ \) made plain; for names that nobody wrote as a label.
std::string plain(std::string const& text);

/// Name of the k-th frame of a film: "slide_0007".
std::string frameName(std::string const& name, std::size_t k);

/// True for a name that is a file name and nothing else: letters, digits and _ - + . = , not beginning with a point.
bool isFileName(std::string const& name);

} // namespace mpsDem::postGauges
