#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/Registry.h"
#include "core/Types.h"
#include "dem/Contact.h"

namespace mpsDem {

/// Material of one pair as a contact law needs it.
struct ContactMaterial
{
    Real stiffnessPerArea = 0;  ///< k_A [N/m3]; linear law.
    Real effectiveModulus = 0;  ///< E* = E / (2 (1 - nu^2)) [Pa]; Hertz.
    Real effectiveShear = 0;    ///< G* = G / (2 (2 - nu)) [Pa]; Mindlin.
    Real tangentialRatio = 0.8; ///< k_t / k_n = 2 (1 - nu) / (2 - nu) [-]; linear law.
    Real mu = 0;                ///< Coefficient of friction [-].
    Real zeta = 0;              ///< Damping ratio [-], from e by dampingRatio().
    Real share = 1;             ///< 0.5 where the same touch is also found from the other body's points [-].
};

/// Force law of all contacts of one pair, eqs 11-12. One virtual call a pair and sub-step.
class ContactLaw
{
public:
    virtual ~ContactLaw() = default;

    /// Sets normalForce, tangentialForce, energies and history of each contact from its geometry.
    /// @param h  Sub-step [s]; `slip` grows by h times the tangential velocity.
    virtual void evaluate(std::span<Contact> contacts, Real h, ContactDissipation& dissipation) const = 0;

    /// Normal and tangential stiffness dF/d(overlap) [N/m] at an overlap [m]; reads area, radius and count of the contact.
    [[nodiscard]] virtual Real normalStiffness(Contact const& contact, Real overlap) const = 0;
    [[nodiscard]] virtual Real tangentialStiffness(Contact const& contact, Real overlap) const = 0;

    /// Largest overlap [m] of an undamped impact of contact.mass at this speed [m/s].
    [[nodiscard]] virtual Real impactOverlap(Contact const& contact, Real speed) const = 0;
};

using ContactLawRegistry = Registry<ContactLaw, ContactMaterial const&>;

/// All laws that contactProperties may name: linearSpringDashpot (default), hertzMindlin, and what others add before a case is read.
ContactLawRegistry& contactLaws();

} // namespace mpsDem
