// Pairs of bodies whose boxes are near one another, against a search through all pairs.

#include <random>

#include <gtest/gtest.h>

#include "dem/BroadPhase.h"
#include "support/SolidScene.h"

namespace mpsDem::test {

namespace {

/// Bodies of different size, turned at random, in a box of 2 m.
struct Crowd
{
    SolidScene scene;
    BroadPhase broadPhase;
    std::vector<Real> margins;
    std::vector<Vector> sizes;

    explicit Crowd(int count)
    {
        std::mt19937 random(7);
        auto const between = [&](Real low, Real high) { return low + (high - low) * static_cast<Real>(random()) / 4294967296.0; };
        for (int i = 0; i < count; ++i)
        {
            sizes.emplace_back(between(0.02, 0.4), between(0.02, 0.1), between(0.02, 0.1));
            Vector const axis(between(-1, 1), between(-1, 1), between(0.1, 1));
            scene.addCuboid("body" + std::to_string(i), sizes.back(), 1000, {between(0, 2), between(0, 2), between(0, 2)},
                            Quaternion(Eigen::AngleAxisd(between(0, 3), axis.normalized())));
            margins.push_back(between(0, 0.05));
            Box box;
            box.add(-0.5 * sizes.back());
            box.add(0.5 * sizes.back());
            broadPhase.add(box, 0.5 * sizes.back().norm());
        }
        broadPhase.update(scene.pointers, margins);
    }

    [[nodiscard]] Box grownBox(std::size_t i) const
    {
        Box box;
        for (int k = 0; k < 8; ++k)
        {
            Vector const sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
            Vector const corner = scene.pointers[i]->toSpace(0.5 * sizes[i].cwiseProduct(sign));
            box.add(corner - Vector::Constant(margins[i]));
            box.add(corner + Vector::Constant(margins[i]));
        }
        return box;
    }
};

} // namespace

TEST(BroadPhase, findsWhatASearchThroughAllPairsFinds)
{
    int const count = 300;
    Crowd const crowd(count);
    std::vector<std::pair<int, int>> expected;
    for (int i = 0; i < count; ++i)
        for (int k = i + 1; k < count; ++k)
        {
            Box const a = crowd.grownBox(static_cast<std::size_t>(i)), b = crowd.grownBox(static_cast<std::size_t>(k));
            if ((a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all()) expected.emplace_back(i, k);
        }
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(crowd.broadPhase.pairs(), expected);
    EXPECT_LT(crowd.broadPhase.comparisons(), static_cast<std::size_t>(count * (count - 1) / 4));
}

TEST(BroadPhase, coversMotionsUpToTheMargin)
{
    Crowd crowd(20);
    EXPECT_TRUE(crowd.broadPhase.covers(crowd.scene.pointers));
    RigidBody& body = *crowd.scene.pointers[4];
    body.setVelocity(Vector(crowd.margins[4], 0, 0), Vector::Zero());
    body.advance(0, 0.99);
    EXPECT_TRUE(crowd.broadPhase.covers(crowd.scene.pointers));
    body.advance(0, 0.02);
    EXPECT_FALSE(crowd.broadPhase.covers(crowd.scene.pointers));
    crowd.broadPhase.update(crowd.scene.pointers, crowd.margins);
    body.setVelocity(Vector::Zero(), Vector(0, 0, 3 * crowd.margins[4] / crowd.sizes[4].x()));
    body.advance(0, 1);
    EXPECT_FALSE(crowd.broadPhase.covers(crowd.scene.pointers));
}

} // namespace mpsDem::test
