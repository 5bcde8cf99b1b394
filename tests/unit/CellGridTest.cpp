#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "particles/CellGrid.h"

namespace mpsDem {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real notANumber = std::numeric_limits<Real>::quiet_NaN();

/// Exit code and message of a grid built of these points; code Done where nothing is refused.
std::pair<ExitCode, std::string> refusal(Field<Vector> const& points, Real cellSize = 0.1, int dimensions = 2)
{
    try
    {
        CellGrid grid;
        grid.build(points, cellSize, dimensions);
    }
    catch (CaseError const& error)
    {
        return {error.code(), error.what()};
    }
    return {ExitCode::Done, ""};
}

TEST(CellGrid, FindsWhatIsWithinReach)
{
    Field<Vector> points;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 10; ++j) points.emplace_back(0.1 * i, 0.1 * j, 0);
    CellGrid grid;
    grid.build(points, 0.21, 2);
    int found = 0;
    grid.forEachWithin(points[55], 0.21, [&](int, Vector const&, Real) { ++found; });
    EXPECT_EQ(found, 13) << "lattice points within 2.1 spacings, the point itself included";
    EXPECT_EQ(refusal(points).first, ExitCode::Done);
    EXPECT_EQ(refusal({}).first, ExitCode::Done) << "no points are a grid, too";
}

TEST(CellGrid, RefusesPositionsThatAreNoNumbers)
{
    for (Real const bad : {notANumber, infinity, -infinity})
        for (int component : {0, 1, 2})
        {
            Field<Vector> points(5, Vector(1, 2, 0));
            points[3][component] = bad;
            auto const [code, text] = refusal(points);
            EXPECT_EQ(code, ExitCode::NotFinite) << bad << " in component " << component;
            EXPECT_NE(text.find("point 3 of 5"), std::string::npos) << text;
        }
    EXPECT_EQ(refusal({Vector(infinity, 0, 0), Vector(-infinity, 0, 0)}).first, ExitCode::NotFinite);
}

TEST(CellGrid, RefusesAnExtentThatIsNoNumber)
{
    constexpr Real most = std::numeric_limits<Real>::max();
    EXPECT_EQ(refusal({Vector(most, 0, 0), Vector(-most, 0, 0)}).first, ExitCode::NotFinite);
    EXPECT_EQ(refusal({Vector(0, 0, 0)}, 0).first, ExitCode::NotFinite) << "cell size 0";
    EXPECT_EQ(refusal({Vector(0, 0, 0)}, notANumber).first, ExitCode::NotFinite);
}

// Cells grow where the points lie far apart, so that their number stays bounded.
TEST(CellGrid, HoldsFewCellsHoweverFarPointsAre)
{
    for (Real const far : {1e3, 1e12, 1e300})
        for (int dimensions : {2, 3})
        {
            Field<Vector> const points{Vector(0, 0, 0), Vector(far, far, dimensions == 3 ? far : 0), Vector(0.05, 0, 0)};
            CellGrid grid;
            grid.build(points, 0.1, dimensions);
            EXPECT_LE(grid.cellCount(), 8 * 3 + 1000);
            int found = 0;
            grid.forEachWithin(points[0], 0.1, [&](int, Vector const&, Real) { ++found; });
            EXPECT_EQ(found, 2) << far;
            found = 0;
            grid.forEachWithin(Vector::Constant(notANumber), 0.1, [&](int, Vector const&, Real) { ++found; });
            EXPECT_EQ(found, 0) << "nothing is near a place that is no number";
        }
}

} // namespace
} // namespace mpsDem
