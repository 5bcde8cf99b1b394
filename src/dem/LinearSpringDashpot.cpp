#include "dem/LinearSpringDashpot.h"

#include "dem/SpringDashpotSlider.h"

namespace mpsDem {

Real LinearSpringDashpot::normalStiffness(Contact const& contact, Real) const
{
    return material_.share * material_.stiffnessPerArea * contact.area;
}

Real LinearSpringDashpot::tangentialStiffness(Contact const& contact, Real overlap) const
{
    return material_.tangentialRatio * normalStiffness(contact, overlap);
}

Real LinearSpringDashpot::impactOverlap(Contact const& contact, Real speed) const
{
    return speed * std::sqrt(contact.mass / normalStiffness(contact, 0));
}

void LinearSpringDashpot::evaluate(std::span<Contact> contacts, Real h, ContactDissipation& dissipation) const
{
    for (Contact& contact : contacts)
    {
        Real const kn = normalStiffness(contact, contact.overlap);
        Real const kt = material_.tangentialRatio * kn;
        Real const cn = 2 * material_.zeta * std::sqrt(kn * contact.mass);
        Real const ct = 2 * material_.zeta * std::sqrt(kt * contact.mass);
        Real const force = addNormalForce(contact, kn * contact.overlap, cn, h, dissipation);
        contact.normalEnergy = 0.5 * kn * contact.overlap * contact.overlap;
        addTangentialForce(contact, kt, ct, force, material_.mu, h, dissipation);
    }
}

} // namespace mpsDem
