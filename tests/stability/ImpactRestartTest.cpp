// H18: a run that stops in the middle of an impact goes on with the same bytes, in water and with the history of its contacts.

#include <fstream>
#include <map>

#include "stability/SlideCase.h"
#include "support/CheckpointSample.h"

namespace mpsDem::test {

namespace {

/// The wedge is 2 cm of height before a stopper with friction, at 3 m/s; a checkpoint after every step.
void writeImpact(RunCase& run)
{
    writeSlide(run, {.top = 0.52, .water = 1, .speed = 3, .stop = "type stopper; mu 0.3; e 0.1; impactSpeed 3;", .stopAt = 0});
    run.write("system/controlDict", "endTime 0.02; deltaT 5e-4; maxDeltaT 5e-4; checkpointInterval 0;\n"
                                    "writeControl timeStep; writeInterval 1; purgeWrite 0; " +
                                        budgetEntry);
}

/// What the stopper holds of its contact at one step.
struct Hit
{
    Real overlap = 0; ///< [m]
    Real slip = 0;    ///< Of the tangential spring [m].
};

/// Contact with the stopper after each step, where there is one.
std::map<std::int64_t, Hit> runToEnd(RunCase& run)
{
    std::map<std::int64_t, Hit> hits;
    run.run([&](Scene const& scene, Step const& step) {
        for (ContactPair const& pair : scene.solids()->contacts()->pairs())
            for (Contact const& contact : pair.contacts())
                if (pair.name() == "slide:foot") hits[step.number] = {contact.overlap, contact.slip.norm()};
    });
    return hits;
}

} // namespace

TEST(ImpactRestart, goesOnWithTheSameBytes)
{
    RunCase unbroken(0.05);
    writeImpact(unbroken);
    std::map<std::int64_t, Hit> const hits = runToEnd(unbroken.make());
    State const end = unbroken.scene().state();
    Hit deepest;
    int same = 0;
    for (auto const& [step, hit] : hits)
    {
        RunCase broken(0.05);
        broken.copyFrom(unbroken);
        for (auto const& entry : std::filesystem::directory_iterator(broken.root() / "checkpoint"))
            if (std::stoll(entry.path().filename().string()) > step) std::filesystem::remove_all(entry.path());
        ASSERT_EQ(broken.start().time().stepNumber(), step);
        EXPECT_GT(broken.scene().solids()->contacts()->contactCount(), 0u);
        runToEnd(broken);
        same += sameBits(end, broken.scene().state());
        deepest = {std::max(deepest.overlap, hit.overlap), std::max(deepest.slip, hit.slip)};
    }
    auto const count = static_cast<Real>(hits.size());
    expectBetween("restart in an impact: steps in contact", count, 3, 40);
    expectBetween("restart in an impact: deepest overlap [spacings]", deepest.overlap / 0.05, 1e-3, 0.05);
    expectBetween("restart in an impact: longest tangential spring [m]", deepest.slip, 1e-9, 0.01);
    expectBetween("restart in an impact: ends with the same bytes", same, count, count);
}

} // namespace mpsDem::test
