#include "scene/ScaleCheck.h"

#include <algorithm>
#include <limits>

#include "core/Errors.h"

namespace mpsDem {

namespace {

constexpr Real mostWallParticles = 30; ///< Over those of the fluid.
constexpr Real largestRatio = 100;     ///< Of extents.

/// Largest side of the box around the particles that count [m]; 0 where none does.
template <class Counts>
Real extent(ParticleSet const& particles, Counts const& counts)
{
    Vector low = Vector::Constant(std::numeric_limits<Real>::infinity()), high = -low;
    for (int const i : particles.owned())
    {
        if (!counts(i)) continue;
        low = low.cwiseMin(particles.r[i]);
        high = high.cwiseMax(particles.r[i]);
    }
    return std::max(Real(0), (high - low).maxCoeff());
}

} // namespace

std::string doubtfulScale(InitialScene const& scene)
{
    ParticleSet const& particles = scene.particles;
    auto const isFluid = [&](int i) { return particles.isFluid(i); };
    auto const isWall = [&](int i) { return !particles.isFluid(i) && particles.body[i] < 0; };
    Real const fluid = particles.fluid().size();
    Real walls = 0;
    for (int const i : particles.boundary()) walls += isWall(i) ? 1 : 0;
    if (!(fluid > 0) || !(walls > 0)) return {};
    Real const spacing = particles.lattice().spacing;
    Real const ratio = (extent(particles, isWall) + spacing) / (extent(particles, isFluid) + spacing);
    std::string const question = ": are the lengths of geometry and regions in the same unit, metres?";
    if (ratio >= largestRatio || ratio <= 1 / largestRatio)
        return "the walls are " + shortNumber(ratio, 3) + " times as large as the fluid" + question;
    if (walls > mostWallParticles * fluid)
        return shortNumber(walls) + " wall and ghost particles are " + shortNumber(walls / fluid, 3) + " times those of the fluid, " +
               shortNumber(fluid) + question;
    return {};
}

} // namespace mpsDem
