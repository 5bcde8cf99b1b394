#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "boundaries/SurfaceRowBuilder.h"
#include "core/Types.h"

namespace mpsDem {

/// Particles spread evenly over the rows behind bent faces: darts of a fixed seed, then steps of mutual repulsion along the row.
///
/// Darts that keep a distance r until none has room have 0.697 particles on r x r (random sequential covering of 0.547 by discs), one on
/// l0 x l0 for r = 0.83 l0; the steps then even them out without a change of their number.
class EvenSpread
{
public:
    /// @param covered  1 for each face that has lines of particles.
    EvenSpread(SurfaceRowBuilder& builder, std::vector<char> const& covered);

    /// Adds the particles of one row behind the faces that are not covered.
    void addRow(int row);

private:
    /// A place on a face by its share of the second and third corner.
    struct Dart
    {
        int face;
        Real u, v;
        Real rank; ///< 0 to 1: a row takes the darts of lower rank than its area over the greatest one.
        int pass;
    };

    /// A particle in the course of being placed.
    struct Particle
    {
        SurfaceRowBuilder::Candidate candidate;
        bool movable;
    };

    [[nodiscard]] Real areaRatio(int face, int row) const;
    [[nodiscard]] Real greatestRatio(int face) const { return std::max(Real(1), areaRatio(face, builder_.ghostRows(face))); }
    void gatherNormals();
    void throwDarts();
    [[nodiscard]] bool isDue(int face, int row) const
    {
        return !covered_[static_cast<std::size_t>(face)] && row <= builder_.ghostRows(face);
    }
    [[nodiscard]] Vector foot(Dart const& dart) const;
    [[nodiscard]] SurfaceRowBuilder::Candidate candidate(Dart const& dart, int row) const;
    [[nodiscard]] SurfaceRowBuilder::Standing settle(SurfaceRowBuilder::Candidate& c, Dart const& dart) const;
    [[nodiscard]] bool pullToRow(SurfaceRowBuilder::Candidate& c) const;
    [[nodiscard]] std::vector<Particle> particles(int row) const;
    void repel(std::vector<Particle>& particles) const;
    void pullAll(std::vector<Particle>& particles, std::vector<SurfaceRowBuilder::Candidate>& lastGood) const;
    [[nodiscard]] Real uniform() { return static_cast<Real>(generator_()) / 4294967296.0; }

    SurfaceRowBuilder& builder_;
    std::vector<char> const& covered_;
    std::vector<std::array<Vector, 3>> normals_; ///< At the corners of each face: mean of the faces that join it smoothly.
    std::vector<Dart> darts_;
    std::mt19937 generator_{20140601};
};

} // namespace mpsDem
