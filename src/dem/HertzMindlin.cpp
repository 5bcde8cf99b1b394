#include "dem/HertzMindlin.h"

#include "dem/SpringDashpotSlider.h"

namespace mpsDem {

Real HertzMindlin::factor(Contact const& contact) const
{
    return material_.share * contact.count * 4.0 / 3.0 * material_.effectiveModulus * std::sqrt(contact.radius);
}

Real HertzMindlin::normalStiffness(Contact const& contact, Real overlap) const { return 1.5 * factor(contact) * std::sqrt(overlap); }

Real HertzMindlin::tangentialStiffness(Contact const& contact, Real overlap) const
{
    return material_.share * contact.count * 8 * material_.effectiveShear * std::sqrt(contact.radius * overlap);
}

Real HertzMindlin::impactOverlap(Contact const& contact, Real speed) const
{
    return std::pow(1.25 * contact.mass * speed * speed / factor(contact), 0.4);
}

void HertzMindlin::evaluate(std::span<Contact> contacts, Real h, ContactDissipation& dissipation) const
{
    for (Contact& contact : contacts)
    {
        Real const k = factor(contact);
        Real const elastic = k * contact.overlap * std::sqrt(contact.overlap);
        Real const cn = 2 * material_.zeta * std::sqrt(1.25 * k * contact.mass * std::sqrt(contact.overlap));
        Real const force = addNormalForce(contact, elastic, cn, h, dissipation);
        contact.normalEnergy = 0.4 * elastic * contact.overlap;

        Real const kt = tangentialStiffness(contact, contact.overlap);
        if (kt > contact.tangentialStiffness) contact.slip *= contact.tangentialStiffness / kt;
        Real const ct = 2 * material_.zeta * std::sqrt(kt * contact.mass);
        addTangentialForce(contact, kt, ct, force, material_.mu, h, dissipation);
    }
}

} // namespace mpsDem
