#include "coupling/PorePressure.h"

#include <algorithm>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include "particles/Kernel.h"

namespace mpsDem {

namespace {

/// Points whose normals are opposite lie on two sides of a thin body: no water flows between them.
constexpr Real opposite = -0.9;
constexpr Real tolerance = 1e-8;

} // namespace

PorePressure::PorePressure(Field<Vector> const& position, Field<Vector> const& normal, Field<Real> const& area, Real reach)
    : links_(position.size())
{
    std::vector<int> byX(position.size());
    for (std::size_t s = 0; s < byX.size(); ++s) byX[s] = static_cast<int>(s);
    std::sort(byX.begin(), byX.end(), [&](int a, int b) { return std::pair(position[a].x(), a) < std::pair(position[b].x(), b); });
    Kernel const w{reach};
    for (std::size_t k = 0; k < byX.size(); ++k)
        for (std::size_t m = k + 1; m < byX.size(); ++m)
        {
            int const i = byX[k], j = byX[m];
            if (position[j].x() - position[i].x() >= reach) break;
            Real const weight = area[i] * area[j] * w((position[j] - position[i]).norm());
            if (weight <= 0 || normal[i].dot(normal[j]) < opposite) continue;
            links_[i].emplace_back(j, weight);
            links_[j].emplace_back(i, weight);
        }
}

void PorePressure::fill(Field<std::uint8_t> const& unknown, Field<Real>& pressure) const
{
    std::vector<int> points, row(unknown.size(), -1);
    for (std::size_t s = 0; s < unknown.size(); ++s)
        if (unknown[s] && !links_[s].empty())
        {
            row[s] = static_cast<int>(points.size());
            points.push_back(static_cast<int>(s));
        }
    if (points.empty()) return;
    int const n = static_cast<int>(points.size());
    std::vector<Eigen::Triplet<Real>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    for (int k = 0; k < n; ++k)
        for (auto const& [j, weight] : links_[points[k]])
        {
            entries.emplace_back(k, k, weight);
            if (row[j] >= 0)
                entries.emplace_back(k, row[j], -weight);
            else
                right[k] += weight * pressure[j];
        }
    Eigen::SparseMatrix<Real> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<Real>, Eigen::Lower | Eigen::Upper> solver(matrix);
    solver.setTolerance(tolerance);
    Eigen::VectorXd const found = solver.solve(right);
    for (int k = 0; k < n; ++k) pressure[points[k]] = found[k];
}

} // namespace mpsDem
