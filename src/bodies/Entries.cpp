#include "bodies/Entries.h"

#include <cmath>

#include <Eigen/LU>

#include "core/Errors.h"

namespace mpsDem {

Real readNumber(Dictionary const& dict, std::string const& key)
{
    Real const value = dict.get<Real>(key);
    require(std::isfinite(value), dict.where(key), key + " is not finite", "a number");
    return value;
}

Real readPositive(Dictionary const& dict, std::string const& key)
{
    Real const value = readNumber(dict, key);
    require(value > 0, dict.where(key), key + " is " + shortNumber(value), "a number above 0");
    return value;
}

Real readNotNegative(Dictionary const& dict, std::string const& key)
{
    Real const value = readNumber(dict, key);
    require(value >= 0, dict.where(key), key + " is " + shortNumber(value), "0 or a number above it");
    return value;
}

Vector readVector(Dictionary const& dict, std::string const& key)
{
    Vector const value = dict.get<Vector>(key);
    require(value.allFinite(), dict.where(key), key + " is not finite", "(x y z)");
    return value;
}

Vector readVectorOr(Dictionary const& dict, std::string const& key, Vector const& fallback)
{
    return dict.found(key) ? readVector(dict, key) : fallback;
}

Vector readDirection(Dictionary const& dict, std::string const& key)
{
    Vector const given = readVector(dict, key);
    require(given.norm() > tiny, dict.where(key), key + " has no length", "a vector other than (0 0 0)");
    return given.normalized();
}

Quaternion readOrientation(Dictionary const& dict, std::string const& key)
{
    if (!dict.found(key)) return Quaternion::Identity();
    Tensor const matrix = dict.get<Tensor>(key);
    bool const rotation = (matrix * matrix.transpose() - Tensor::Identity()).norm() < 1e-5 && matrix.determinant() > 0;
    require(rotation, dict.where(key), key + " is not a rotation", "nine numbers, row by row, of a rotation matrix");
    return Quaternion(matrix).normalized();
}

} // namespace mpsDem
