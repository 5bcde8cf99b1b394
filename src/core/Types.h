#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace mpsDem {

using Real = double;
using Vector = Eigen::Vector3d; ///< Always three components; in 2-D the third one stays zero.
using Tensor = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// One contiguous value per particle (or per surface point).
template <class T>
using Field = std::vector<T>;

/// Smallest number by which lengths, masses or norms are divided without a further check.
inline constexpr Real tiny = 1e-300;

} // namespace mpsDem
