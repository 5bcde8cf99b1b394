// n0, lambda and |F|_0 of the full square lattice against sums made apart from the code.

#include <cmath>

#include "particles/ReferenceConstants.h"
#include "support/RunCase.h"

namespace mpsDem::test {

namespace {

struct Row
{
    Real radius, n0, lambda, factor, planeSurface;
};

void compare(int dimensions, Row const& row)
{
    Lattice lattice;
    lattice.dimensions = dimensions;
    lattice.spacing = 1;
    ReferenceConstants const found = referenceConstants(lattice, row.radius);
    std::string const at = std::to_string(dimensions) + "-D, re " + std::to_string(row.radius).substr(0, 4) + ": ";
    expectBelow(at + "n0, error", found.n0 - row.n0, 1e-4);
    expectBelow(at + "lambda, error [spacing^2]", found.lambda - row.lambda, 1e-4);
    expectBelow(at + "2 d/(n0 lambda), error", found.laplacianFactor(dimensions) - row.factor, 1e-4);
    expectBelow(at + "|F|_0, error", found.planeSurface - row.planeSurface, 1e-4);
}

} // namespace

TEST(ReferenceConstants, agreeWithTheLatticeSums)
{
    for (Row const& row :
         {Row{2.1, 4.9160, 1.4156, .5748, .5648}, Row{3.1, 13.5132, 2.6065, .1136, .5890}, Row{4.01, 24.6717, 4.0829, .0397, .6010}})
        compare(2, row);
    for (Row const& row :
         {Row{2.1, 11.0793, 1.7374, .3117, .6324}, Row{3.1, 40.3232, 3.4072, .0437, .6796}, Row{4.01, 91.2849, 5.5857, .0118, .7021}})
        compare(3, row);
}

// Everything scales with the spacing: n0 and |F|_0 do not change, lambda goes with its square.
TEST(ReferenceConstants, scaleWithTheSpacing)
{
    Lattice one, small;
    one.spacing = 1;
    small.spacing = 0.02;
    ReferenceConstants const a = referenceConstants(one, 2.1), b = referenceConstants(small, 2.1 * 0.02);
    expectBelow("n0 at spacing 0.02 over 1, minus 1", b.n0 / a.n0 - 1, 1e-12);
    expectBelow("lambda at spacing 0.02, scaled, minus 1", b.lambda / (0.02 * 0.02) / a.lambda - 1, 1e-12);
    expectBelow("|F|_0 at spacing 0.02 over 1, minus 1", b.planeSurface / a.planeSurface - 1, 1e-12);
}

} // namespace mpsDem::test
