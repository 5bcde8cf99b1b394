#pragma once

#include "dem/ContactLaw.h"

namespace mpsDem {

/// Linear springs, dashpots and slider of eqs 11-12 (P. Cundall, O. Strack, Geotechnique 29, 1979).
///
/// \f[ F^n = k_n \delta^n - c_n v_n \ge 0, \quad F^t = -k_t \xi - c_t v_t, \quad |F^t| \le \mu F^n \f]
/// k_n = k_A A: stiffness per area times the area of the point, so that a face is as stiff on coarse as on fine points.
/// k_t = k_n 2(1 - nu)/(2 - nu) (Mindlin); c = 2 zeta sqrt(k m), zeta from e.
class LinearSpringDashpot final : public ContactLaw
{
public:
    explicit LinearSpringDashpot(ContactMaterial const& material) : material_(material) {}

    void evaluate(std::span<Contact> contacts, Real h, ContactDissipation& dissipation) const override;
    [[nodiscard]] Real normalStiffness(Contact const& contact, Real overlap) const override;
    [[nodiscard]] Real tangentialStiffness(Contact const& contact, Real overlap) const override;
    [[nodiscard]] Real impactOverlap(Contact const& contact, Real speed) const override;

private:
    ContactMaterial material_;
};

} // namespace mpsDem
