#pragma once

#include <memory>

#include "core/Ledger.h"
#include "fluid/Collision.h"
#include "fluid/FreeSurface.h"
#include "fluid/Shifting.h"
#include "fluid/SurfaceDamping.h"
#include "fluid/VelocityDamping.h"
#include "fluid/Viscosity.h"
#include "parallel/Reduce.h"
#include "particles/Gradient.h"

namespace mpsDem {

/// What happens to pressures below zero: `limiters { negativePressure clamp; }`.
enum class NegativePressure
{
    Clamp,    ///< p >= 0 everywhere.
    Interior, ///< Only surface and near-surface particles and walls beside them are clamped.
    Keep      ///< Nothing is clamped.
};

/// The fluid's own part of a step: eq 2 in two halves around the pressure.
///
/// `limiters`:
/// | key | meaning | unit | default (standard, paper) | range |
/// | displacement | largest \f$|\mathbf a_p|\Delta t^2\f$ of the pressure gradient; 0: no limit | spacings | 0.1, 0 | 0..1 |
/// | negativePressure | clamp, interior or keep | - | clamp | - |
class Fluid
{
public:
    /// @param schemes   system/mpsSchemes. @param nu kinematic viscosity [m2/s]. @param largestDt of the run [s].
    Fluid(Dictionary const& schemes, SchemeSet set, Lattice const& lattice, Radii const& radii, Real density, Real nu,
          Vector const& gravity, Real largestDt, Ledger& ledger);

    [[nodiscard]] ReferenceConstants const& gradientConstants() const { return gradientConstants_; }
    [[nodiscard]] ReferenceConstants const& laplacianConstants() const { return laplacianConstants_; }
    [[nodiscard]] FreeSurface const& freeSurface() const { return *freeSurface_; }
    [[nodiscard]] Viscosity const* viscosity() const { return viscosity_.get(); }
    [[nodiscard]] VelocityDamping const* velocityDamping() const { return velocityDamping_.get(); }
    [[nodiscard]] Collision const* collision() const { return collision_.get(); }
    [[nodiscard]] bool dampsSurface() const { return surfaceDamping_ != nullptr; }
    [[nodiscard]] bool limitsDisplacement() const { return displacementLimit_ > 0; }
    [[nodiscard]] Shifting* shifting() const { return shifting_.get(); }
    [[nodiscard]] NegativePressure negativePressure() const { return negativePressure_; }
    [[nodiscard]] Real density() const { return density_; }
    [[nodiscard]] Real nu() const { return nu_; }

    /// Eq 2 without the pressure: u* = u + dt (g + nu <lap u>). @pre uStar of boundary particles is theirs.
    void predict(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt);

    /// Treats negative pressures.
    void clampPressure(ParticleSet& particles, NeighbourList const& neighbours) const;

    /// Eq 4 and the rest of eq 2: u = u* - dt <grad p>/rho, r = r + dt u (symplectic).
    void correct(ParticleSet& particles, NeighbourList const& neighbours, Real dt);

    /// Particle collision, where the case has it.
    void collide(ParticleSet& particles, NeighbourList const& neighbours, PeriodicImages const& images, Real dt);

    /// Times that the displacement limit was needed, since the start of this run and in the last step, over all ranks.
    [[nodiscard]] std::int64_t limited() const { return sumOverRanks(limited_); }
    [[nodiscard]] int limitedNow() const { return sumOverRanks(limitedNow_); }
    /// The last step is undone: it does not count.
    void forgetLimited()
    {
        limited_ -= limitedNow_;
        limitedNow_ = 0;
    }

private:
    ReferenceConstants gradientConstants_, laplacianConstants_;
    Real density_, nu_;
    Vector gravity_;
    std::unique_ptr<GradientScheme> gradient_;
    std::unique_ptr<FreeSurface> freeSurface_;
    std::unique_ptr<Viscosity> viscosity_;
    std::unique_ptr<Collision> collision_;
    std::unique_ptr<Shifting> shifting_;
    std::unique_ptr<SurfaceDamping> surfaceDamping_;
    std::unique_ptr<VelocityDamping> velocityDamping_;
    Real displacementLimit_; ///< [m]; 0: none.
    NegativePressure negativePressure_;
    std::int64_t limited_ = 0; ///< Of this rank, as the next one.
    int limitedNow_ = 0;
    Field<Vector> pressureGradient_;
};

} // namespace mpsDem
