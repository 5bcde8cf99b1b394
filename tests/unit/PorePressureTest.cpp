// Pressure of a contact face in 3-D from that of its rim.

#include <algorithm>
#include <cmath>

#include "coupling/PorePressure.h"
#include "support/Measured.h"

namespace mpsDem::test {

namespace {

/// Points one apart in a square of 11 x 11, those of its outermost row known.
struct Face
{
    Field<Vector> position, normal;
    Field<Real> area;
    Field<std::uint8_t> unknown;

    explicit Face(Real z = 0, Real up = 1) { add(z, up); }

    void add(Real z, Real up)
    {
        for (int i = 0; i < 11; ++i)
            for (int j = 0; j < 11; ++j)
            {
                position.emplace_back(i, j, z);
                normal.emplace_back(0, 0, up);
                area.push_back(1);
                unknown.push_back(i > 0 && i < 10 && j > 0 && j < 10);
            }
    }

    [[nodiscard]] Field<Real> filled(Field<Real> pressure) const
    {
        PorePressure(position, normal, area, 1.2).fill(unknown, pressure);
        return pressure;
    }
};

} // namespace

TEST(PorePressure, continuesALinearRimLinearly)
{
    Face const face;
    Field<Real> given(face.position.size(), 0);
    for (std::size_t s = 0; s < given.size(); ++s)
        if (!face.unknown[s]) given[s] = 3 + 2 * face.position[s].x() - face.position[s].y();
    Field<Real> const found = face.filled(given);
    Real worst = 0;
    for (std::size_t s = 0; s < found.size(); ++s)
        worst = std::max(worst, std::abs(found[s] - (3 + 2 * face.position[s].x() - face.position[s].y())));
    expectBelow("pore pressure, linear rim: largest error", worst, 1e-6);
}

TEST(PorePressure, liesBetweenTheValuesOfTheRim)
{
    Face const face;
    Field<Real> given(face.position.size(), 0);
    given[5] = 1; // one wet point
    Field<Real> const found = face.filled(given);
    expectBetween("pore pressure, one wet point: least", *std::min_element(found.begin(), found.end()), 0, 1e-3);
    expectBetween("pore pressure, one wet point: beside it", found[5 + 11], 0.2, 0.5);
}

TEST(PorePressure, doesNotReachThroughAThinBody)
{
    Face both;
    both.add(0.5, -1);
    Field<Real> given(both.position.size(), 0);
    for (std::size_t s = 0; s < 121; ++s) given[s] = 1;
    Field<Real> const found = both.filled(given);
    expectBelow("pore pressure of the other side", *std::max_element(found.begin() + 121, found.end()), 1e-12);
}

} // namespace mpsDem::test
