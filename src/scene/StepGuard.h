#pragma once

#include <array>
#include <memory>
#include <ostream>
#include <vector>

#include "bodies/RigidBody.h"
#include "core/Dictionary.h"
#include "core/Step.h"
#include "particles/ParticleSet.h"
#include "particles/SchemeSet.h"

namespace mpsDem {

/// Tells which steps went wrong and are to be taken again with half their length: `redoSteps {...}` of system/controlDict.
///
///   energy   the water's energy rises by more than the work of the bodies on it and a share of all the energy there is:
///            \f[ E^{m+1} - E^m - \max(0, W) > \epsilon E_0,\qquad E = \sum_i m\,(u_i^2/2 - \mathbf g\cdot\mathbf r_i),\qquad
///                W = -\Delta t\sum_b(\mathbf F_b\cdot\mathbf V_b + \mathbf M_b\cdot\boldsymbol\omega_b) \f]
///            F_b, M_b: load of the water on body b; E_0: the largest E of the run, counted from the lowest particle of its start. What
///            falls is loss and never counts: water against a wall, a body at its stop.
///   limiter  the displacement by the pressure gradient had to be limited for more than a share of the water's particles
///   wall     a particle passed the wall row, half a spacing behind the surface, and more than a quarter of a spacing in the step
///   solver   the step could not be ended (exit code 7): pressure without convergence, contact with too many sub-steps or too much overlap
///
/// A step is halved three times at most, and only while each half leaves less than three quarters of the excess: two particles that come
/// too near each other part with an energy that no step makes less. Then the longest step than which no shorter one is clearly better is
/// taken and kept, or the run ends with the message of the solver. Afterwards steps grow by the usual tenth. With fixed steps nothing is
/// taken again: energy and limiter are watched and told.
///
/// What single steps may is too much where it goes on: the run is over once the water has gained more than a share of what it began with and
/// was given,
/// \f[ B^m - \min_{k \le m} B^k > \gamma\,(E^0 + \sum_m \max(0, W)),\qquad B^m = \sum_{k \le m} (E^{k+1} - E^k - \max(0, W)) \f]
/// over the steps as they were kept. Nothing but bodies gives energy to the water, so B falls but for errors.
///
/// | key | meaning | unit | default (standard, paper) | range |
/// | active | whether steps are watched | - | yes, no | - |
/// | energyRise | epsilon; 0: not watched | - | 0.001 | 0..1 |
/// | limited | share of limited displacements; 0: not watched | - | 0.005 | 0..1 |
/// | energyGain | gamma; 0: no limit | - | 0.2 | 0..1e6 |
class StepGuard
{
public:
    /// @param controlDict  system/controlDict. @param adjustable  adjustTimeStep. @param gravity [m/s2]. @param density  Of water [kg/m3].
    StepGuard(Dictionary const& controlDict, SchemeSet set, bool adjustable, Vector const& gravity, Real density);

    /// Takes over what an edited controlDict says; what was counted stays.
    void take(StepGuard const& edited);

    /// Whether steps are watched; whether they are also taken again.
    [[nodiscard]] bool active() const { return active_; }
    [[nodiscard]] bool redoes() const { return active_ && adjustable_; }

    /// A step is chosen where the flow allows `limit` [s].
    /// @throw CaseError Solver where it has been below a thousandth of the limit, and of the longest step so far, for 50 steps.
    void choose(Step const& step, Real limit);
    /// A try of the step begins, fluid sorted and wrapped.
    void begin(ParticleSet const& particles);
    /// A try of the step has ended. @param limited  Limited displacements. @param crossed  Wall particles that were passed; of all ranks.
    /// @return false where another try is to be made.
    [[nodiscard]] bool accepts(Step const& step, ParticleSet const& particles, std::vector<std::unique_ptr<RigidBody>> const& bodies,
                               int limited, int crossed);
    /// A try of the step broke off. @return false where no other one can mend it.
    [[nodiscard]] bool mends(Step const& step, CaseError const& error);
    /// Length of the try to be made [s].
    [[nodiscard]] Real again() const { return again_; }

    enum Cause
    {
        Energy,
        Limiter,
        Wall,
        Failure,
        causes
    };
    /// Steps since the start that were taken again, by the first cause; those of them that were kept although something was found.
    [[nodiscard]] std::int64_t redone(Cause cause) const { return redone_[cause]; }
    [[nodiscard]] std::int64_t redone() const { return redone_[Energy] + redone_[Limiter] + redone_[Wall] + redone_[Failure]; }
    [[nodiscard]] std::int64_t kept() const { return kept_; }
    /// What the water has gained, over what it began with and was given.
    [[nodiscard]] Real gain() const;
    /// @throw CaseError Solver where that is more than energyGain. @param time  Of the state that has been saved [s].
    void requireNoGain(Real time) const;
    [[nodiscard]] bool gainedTooMuch() const { return active_ && largestGain_ > 0 && gain() > largestGain_; }
    /// One line for the end of the log, where anything was found.
    void report(std::ostream& os) const;

    void save(State& state) const;
    void load(State const& state);

private:
    /// What was found in a try, over what is allowed.
    struct Try
    {
        Real dt = 0, excess = 0;
    };

    [[nodiscard]] Real energy(ParticleSet const& particles) const;
    /// Whether a try is kept. @param rise  Of the energy, over E_0. @param share  Of particles whose displacement was limited.
    [[nodiscard]] bool judge(Step const& step, Real rise, Real share, int crossed);
    [[nodiscard]] bool refuse(Step const& step, Cause cause, Real excess, std::string const& finding);
    [[nodiscard]] bool helpsToHalve() const;
    void tell(Step const& step, std::string const& finding, std::string const& answer) const;

    static constexpr int mostHalvings = 3;

    bool active_, adjustable_;
    Real largestRise_, largestLimited_, largestGain_;
    Vector gravity_;
    Real density_;
    std::array<Try, mostHalvings + 1> tries_; ///< Of the present step.
    int tried_ = 0;
    bool last_ = false; ///< The present try is kept whatever is found.
    Real again_ = 0;    ///< [s]
    Real begin_ = 0;    ///< Energy at the begin of the step [J].
    // State: saved.
    std::array<std::int64_t, causes> redone_{};
    std::int64_t kept_ = 0, tiny_ = 0; ///< tiny_: steps one after the other.
    bool begun_ = false;
    Real lowest_ = 0, available_ = 0; ///< Least -g.r at the start [m2/s2]; E_0 [J].
    Real longest_ = 0;                ///< Step so far [s].
    Real given_ = 0;                  ///< E^0 and the work of bodies [J].
    Real balance_ = 0, least_ = 0;    ///< B and its minimum [J].
};

} // namespace mpsDem
