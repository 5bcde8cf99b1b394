#pragma once

#include "dem/ContactLaw.h"

namespace mpsDem {

/// Hertz's normal and Mindlin's no-slip tangential force in eqs 11-12, each point a sphere.
///
/// \f[ F^n = \tfrac43 E^* \sqrt{R}\,\delta^{3/2} - c_n v_n \ge 0,
///     \quad c_n = 2\zeta\sqrt{\tfrac54 \cdot \tfrac43 E^*\sqrt R\, m}\;\delta^{1/4} \f]
/// \f[ k_t = 8 G^* a, \quad a = \sqrt{R\delta}, \quad |F^t| \le \mu F^n \f]
/// The tangential force is kept while delta grows and shrinks with k_t while delta falls, so that the spring never gains energy.
/// Source: K. Johnson, Contact Mechanics (1985), 4.2, 7.2; C. Thornton, S. Cummins, P. Cleary, Powder Technology 233 (2013).
/// Forces count `count` equal spheres side by side; stiffness depends on the spacing of the points, unlike that of the linear law.
class HertzMindlin final : public ContactLaw
{
public:
    explicit HertzMindlin(ContactMaterial const& material) : material_(material) {}

    void evaluate(std::span<Contact> contacts, Real h, ContactDissipation& dissipation) const override;
    [[nodiscard]] Real normalStiffness(Contact const& contact, Real overlap) const override;
    [[nodiscard]] Real tangentialStiffness(Contact const& contact, Real overlap) const override;
    [[nodiscard]] Real impactOverlap(Contact const& contact, Real speed) const override;

private:
    /// 4/3 E* sqrt(R) of all spheres of the point [N/m^1.5].
    [[nodiscard]] Real factor(Contact const& contact) const;

    ContactMaterial material_;
};

} // namespace mpsDem
