#pragma once

#include <algorithm>
#include <cmath>

#include "dem/Contact.h"

namespace mpsDem {

/// Normal force of eq 11 with spring force and dashpot as given by the law: sets normalForce.
///
/// \f[ F^n = \max(0,\; \frac{F_e - c\,v_n}{1 + c h/(2m)}) \f]
/// Body velocities stand half a sub-step behind positions (semi-implicit Euler); the denominator takes the dashpot at the
/// middle of the velocity step, so that it is second order in h. A contact began some fraction f of a sub-step ago: its
/// first dashpot force covers f + 1/2 of a sub-step. No force ever pulls. Between sides that are held no force changes v_n.
/// @param elastic  Spring force F_e [N].
/// @param damping  c [N s/m].
/// @return Size of the force [N].
inline Real addNormalForce(Contact& contact, Real elastic, Real damping, Real h, ContactDissipation& dissipation)
{
    Real const vn = contact.velocity.dot(contact.normal);
    Real cover = 1;
    if (contact.fresh && vn < 0) cover = 0.5 + std::min(Real(1), contact.overlap / (-vn * h));
    Real const c = damping * cover;
    Real const force = std::max(Real(0), (elastic - c * vn) / (1 + (contact.held ? 0 : 0.5 * c * h / contact.mass)));
    Real const middleVelocity = vn + (contact.held ? 0 : 0.5 * h * force / contact.mass);
    if (damping > 0) dissipation.normal += (elastic - force) * middleVelocity * h;
    contact.normalForce = force * contact.normal;
    return force;
}

/// Tangential force of eq 12: spring with history, dashpot while it sticks, Coulomb slider. Sets tangentialForce and slip.
///
/// \f[ F^t = -k_t \xi - c_t v_t, \quad |k_t\xi| > \mu F^n:\; \xi := \mu F^n/k_t\;\xi/|\xi|,\; F^t = -k_t\xi \f]
/// The slider works on the spring force, and the dashpot acts only while the spring sticks: during slip the force is mu F^n exactly
/// and the spring holds no more energy than (mu F^n)^2 / (2 k_t), however fast the slide was. Where spring and dashpot together
/// exceed mu F^n, the force is cut to mu F^n.
inline void addTangentialForce(Contact& contact, Real stiffness, Real damping, Real normalForce, Real mu, Real h,
                               ContactDissipation& dissipation)
{
    Vector const vt = contact.velocity - contact.velocity.dot(contact.normal) * contact.normal;
    Real const limit = mu * normalForce;
    if (!contact.fresh) contact.slip += h * vt;
    Real const elastic = stiffness * contact.slip.norm();
    if (elastic > limit)
    {
        contact.slip *= limit / elastic;
        contact.tangentialForce = -stiffness * contact.slip;
    }
    else
    {
        Real const c = damping / (1 + (contact.held ? 0 : 0.5 * damping * h / contact.mass));
        contact.tangentialForce = -stiffness * contact.slip - c * vt;
        Real const size = contact.tangentialForce.norm();
        if (size > limit) contact.tangentialForce *= limit / size;
    }
    contact.tangentialStiffness = stiffness;
    Real const energy = 0.5 * stiffness * contact.slip.squaredNorm();
    dissipation.tangential += -contact.tangentialForce.dot(vt) * h - (energy - contact.tangentialEnergy);
    contact.tangentialEnergy = energy;
}

} // namespace mpsDem
