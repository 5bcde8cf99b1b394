#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/Types.h"
#include "parallel/Communicator.h"

namespace mpsDem {

/// Reductions over the particles of all ranks: all sums, extremes and counts that more than one rank takes part in.
///
/// `...OverRanks` takes the number of this rank; `sumOver`, `maxOver`, ... also loop over this rank's part, e.g. particles.fluid(), in its
/// order, so that on one rank the result is that of a plain loop to the last bit. All are collective.

/// Least or largest number, and whether all numbers looked at were finite: a NaN or an infinity does not get lost on its way.
struct Extremum
{
    Real value = 0;
    bool finite = true;
};

template <std::integral T>
T sumOverRanks(T value)
{
    std::int64_t sum = static_cast<std::int64_t>(value);
    Communicator::sum(std::span(&sum, 1));
    return static_cast<T>(sum);
}

inline Real sumOverRanks(Real value)
{
    Communicator::sum(std::span(&value, 1));
    return value;
}

/// Vectors and matrices of fixed size, entry by entry.
template <int rows, int columns>
Eigen::Matrix<Real, rows, columns> sumOverRanks(Eigen::Matrix<Real, rows, columns> value)
{
    Communicator::sum(std::span<Real>(value.data(), static_cast<std::size_t>(value.size())));
    return value;
}

inline bool anyOverRanks(bool value) { return sumOverRanks(std::int64_t{value}) > 0; }

inline Extremum maxOverRanks(Extremum local)
{
    Communicator::max(std::span(&local.value, 1));
    return {local.value, !anyOverRanks(!local.finite)};
}

inline Extremum minOverRanks(Extremum local)
{
    Communicator::min(std::span(&local.value, 1));
    return {local.value, !anyOverRanks(!local.finite)};
}

/// Component by component, of finite vectors: corners of boxes.
inline Vector maxOverRanks(Vector value)
{
    Communicator::max(std::span<Real>(value.data(), 3));
    return value;
}

inline Vector minOverRanks(Vector value)
{
    Communicator::min(std::span<Real>(value.data(), 3));
    return value;
}

/// `start` and value(i) of all indices, summed.
template <class Indices, class T, class Value>
T sumOver(Indices const& indices, T start, Value value)
{
    for (int const i : indices) start += value(i);
    return sumOverRanks(start);
}

/// Number of indices for which test(i) holds.
template <class Indices, class Test>
std::int64_t countOver(Indices const& indices, Test test)
{
    return sumOver(indices, std::int64_t{0}, [&](int i) { return std::int64_t{test(i)}; });
}

/// Largest of `start` and value(i) of all indices that is a number.
template <class Indices, class Value>
Extremum maxOver(Indices const& indices, Real start, Value value)
{
    Extremum local{start, true};
    for (int const i : indices)
    {
        Real const v = value(i);
        local.value = std::max(local.value, v); // the first one where v is a NaN
        local.finite = local.finite && std::isfinite(v);
    }
    return maxOverRanks(local);
}

/// Least of `start` and value(i) of all indices that is a number.
template <class Indices, class Value>
Extremum minOver(Indices const& indices, Real start, Value value)
{
    Extremum local{start, true};
    for (int const i : indices)
    {
        Real const v = value(i);
        local.value = std::min(local.value, v);
        local.finite = local.finite && std::isfinite(v);
    }
    return minOverRanks(local);
}

/// An extreme value and the particle that has it.
struct Place
{
    Real value = 0;
    std::int64_t id = -1; ///< -1: none.
    Vector position = Vector::Zero();
};

/// The larger one, and of equal ones that with the smaller id; the other one where one is none, or its value is a NaN.
inline Place largerOf(Place const& a, Place const& b)
{
    if (b.id < 0 || std::isnan(b.value)) return a;
    bool const second = a.id < 0 || b.value > a.value || (b.value == a.value && b.id < a.id);
    return second ? b : a;
}

/// The largest one of all ranks.
inline Place maxOverRanks(Place local)
{
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    Real value = local.id < 0 ? -infinity : local.value;
    Communicator::max(std::span(&value, 1));
    Real id = local.id >= 0 && local.value == value ? static_cast<Real>(local.id) : infinity;
    Communicator::min(std::span(&id, 1));
    if (static_cast<Real>(local.id) != id) local.position.setZero();
    return {value, std::isfinite(id) ? static_cast<std::int64_t>(id) : -1, sumOverRanks(local.position)};
}

/// Value below which a share of the numbers of all ranks lies; the numbers are reordered. 0 where there is none.
inline Real quantileOverRanks(std::vector<Real>& values, Real share)
{
    if (values.empty()) return 0;
    auto const nth = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<Real>(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

} // namespace mpsDem
