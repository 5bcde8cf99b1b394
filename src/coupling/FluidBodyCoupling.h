#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"
#include "core/Step.h"
#include "coupling/WettedSurface.h"
#include "particles/NeighbourList.h"

namespace mpsDem {

/// Answers what pressure a given acceleration of the boundary particles causes (the pressure library, seen from here).
using PressureResponse = std::function<void(Field<Vector> const& acceleration, Field<Real>& pressure)>;

/// Fluid and one rigid body: its boundary particles follow it, the pressure loads it (eqs 15-16), and where the body is light its
/// acceleration and the pressure are found together.
///
/// `coupling { type auto; }` of system/mpsSolution:
///   weak    the load of this step's pressure moves the body (paper); unstable at any time step where the added mass reaches the mass.
///           lambda, the largest eigenvalue of M^{-1} M_a over the free directions, above 0.8: refused in the first step, warned of once
///           later; warned of once above 0.5
///   strong  the pressure is linear in the acceleration a of the body, p = p0 + sum_k (a_k - a*_k) p_k, so that
///           \f[ (M + M_a)\,\dot V = F_g + F_c + F_H(a^*) + M_a a^*, \qquad M_{a,lk} = -\mathrm{PI}_l(p_k) \f]
///           is solved in the contact sub-steps; then p is corrected. One pass, no iteration; 3 more solves a step in 2-D, 6 in 3-D
///   lagged  as strong, with M_a and p_k renewed every `addedMassInterval` steps and the pressure left uncorrected
///   auto    weak, and strong from the first step on in which lambda is found to be above 0.5
///
/// While the coupling is weak, lambda is found in the first step, every 50th, and whenever twice as much of the surface is wet as at the
/// last time.
/// In weak mode u* of the body's particles is their u: the change of u since the last step, a dt of that step, is what eq 8 answers, so the
/// slopes and ghosts that take the body's last acceleration agree with it. u + a dt instead would make eq 8 answer 2 a - a' (a' that of the
/// step before): an error grows by the roots of x^2 + 2 lambda x - lambda, stable up to lambda = 1/3 only and not up to 1.
///
/// | key | meaning | unit | default | range |
/// | type | weak, strong, lagged, auto | - | auto | - |
/// | addedMassInterval | steps (lagged) | - | 10 | 1..1000 |
/// | contactFace | dry: no pressure where two solids touch (paper); pore: that of the wet rim; vented: that of the body's other side | - | dry | - |
/// | faceReach | pore, vented: dry points that another solid faces within this distance in front lie on a contact face | spacing | 2.1, 1.5 | 0.5..20 |
/// With pore, wall particles of two solids that part are 2 spacings apart before fluid finds room between them: until then there must be
/// pressure, or a light body that lies on a floor never leaves it.
class FluidBodyCoupling
{
public:
    enum class Mode
    {
        Weak,
        Strong,
        Lagged
    };

    /// What the keys above say.
    struct Controls
    {
        Mode mode;
        Location where; ///< Of `type`, for messages.
        bool automatic;
        int addedMassInterval;
        PressureIntegrationControls integration;
    };
    /// Reads `coupling` of system/mpsSolution. @param positiveOnly  Whether pressures below zero count as zero.
    /// @throw CaseError BadInput for an unknown word or a number out of its range.
    static Controls readControls(Dictionary const& coupling, Lattice const& lattice, bool positiveOnly);

    /// @param body     Number of the body in particles.body.
    /// @param outline  In body axes.
    FluidBodyCoupling(RigidBody& body, int number, Surface const& outline, ParticleSet const& particles, Controls const& controls,
                      Vector const& gravity, Real density);

    /// Sets position, velocity, normal and acceleration of the body's particles.
    void moveParticles(ParticleSet& particles);
    /// u* of the body's particles: the velocity they are assumed to have at the end of the step.
    void predictParticles(ParticleSet& particles, Real dt) const;

    /// Load of the pressure just solved for; in strong mode also the added mass, by `response`.
    /// @throw CaseError BadInput for weak coupling of a body with too much added mass in the first step.
    void load(ParticleSet const& particles, NeighbourList const& neighbours, Step const& step, PressureResponse const& response);
    /// Corrects pressure and load for the acceleration that the body has had in truth (strong). After body.endStep().
    void correct(ParticleSet& particles);

    [[nodiscard]] RigidBody const& body() const { return body_; }
    [[nodiscard]] WettedSurface const& surface() const { return surface_; }
    [[nodiscard]] Mode mode() const { return mode_; }
    /// lambda [-] of the added mass found last; 0 before any, and for a body without a free direction.
    [[nodiscard]] Real addedMassRatio() const;
    /// For the log: mode, or that `auto` has not found the added mass yet.
    [[nodiscard]] char const* modeName() const;

    void save(State& state) const;
    void load(State const& state);

private:
    [[nodiscard]] Vector6 assumedAcceleration() const;
    void findAddedMass(ParticleSet const& particles, NeighbourList const& neighbours, PressureResponse const& response);
    [[nodiscard]] Load integrate(ParticleSet const& particles, NeighbourList const& neighbours);
    [[nodiscard]] bool weakIsToBeChecked(Step const& step);
    void checkWeak(Step const& step);
    void decide(Real ratio, std::string const& text);

    RigidBody& body_;
    Controls controls_;
    Mode mode_;
    Vector gravity_;
    Real density_;
    Field<int> particle_;
    Field<Vector> local_, localNormal_;
    WettedSurface surface_;
    Matrix6 addedMass_ = Matrix6::Zero();
    Vector6 assumed_ = Vector6::Zero();
    std::int64_t checkedWet_ = 0;       ///< Wet points when the added mass was last held against the mass (weak); 0: not yet.
    Real warnedOf_ = 0;                 ///< The limit of lambda that the log has told to be exceeded.
    std::vector<int> direction_;        ///< Free degrees of freedom.
    std::vector<Field<Real>> response_; ///< p_k of each [Pa s2/m].
    Field<Vector> unitAcceleration_;
};

} // namespace mpsDem
