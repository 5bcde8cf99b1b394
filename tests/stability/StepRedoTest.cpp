// A step that goes wrong is undone without a trace and taken again with half its length.

#include <functional>
#include <utility>

#include "stability/SlideCase.h"
#include "support/CheckpointSample.h"

namespace mpsDem::test {

namespace {

/// The wedge in water on its slope, with friction and a momentum budget.
void writeWedge(RunCase& run, std::string const& control = "")
{
    writeSlide(run, {.top = 0.52, .water = 1, .speed = 1, .stop = "type stopper; mu 0.3; e 0.1; impactSpeed 3;", .stopAt = 0});
    run.control(1, 1e-3, budgetEntry + control).make();
}

/// Still water of 0.2 m by 0.4 m, 800 particles.
void writeTank(RunCase& run, std::string const& control = "")
{
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 0.8 0) (0 0 0) (0.4 0 0) (0.4 0.8 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.4 0.2 0); } );\nhydrostatic { surface 0.2; }");
    run.control(1, 1e-3, control).make();
}

ParticleSet& particlesOf(Scene& scene) { return const_cast<ParticleSet&>(scene.particles()); }

/// Takes a step whose first try is spoilt: before eq 4, or after all stages.
Step spoiltStep(RunCase& run, std::function<void(Scene&)> const& beforeEnd, std::function<void(Scene&)> const& atEnd)
{
    Scene& scene = run.start();
    bool first = true;
    Step const taken = scene.takeStep([&](Step const& step) {
        scene.moveBoundaries();
        scene.updateNeighbours(step);
        scene.label();
        scene.predict(step);
        scene.solvePressure(step);
        scene.loadBodies(step);
        scene.advanceBodies(step);
        bool const spoil = std::exchange(first, false);
        if (spoil && beforeEnd) beforeEnd(scene);
        scene.correctFluid(step);
        if (spoil && atEnd) atEnd(scene);
    });
    scene.observe(taken);
    return taken;
}

void fail(Scene&) { throw CaseError(ExitCode::Solver, "spoilt by the test"); }

void speedUp(Scene& scene)
{
    for (int const i : scene.particles().fluid()) particlesOf(scene).u[i].y() += 1;
}

/// Blocks of two states that differ, the count of causes not among them.
int differences(State const& a, State const& b)
{
    int count = a.blocks().size() != b.blocks().size();
    for (auto const& [name, block] : a.blocks()) count += name != "stepGuard/counts" && (!b.has(name) || b.blocks().at(name) != block);
    return count;
}

/// Dam break with steps four times as long as usual, a checkpoint after every step.
void writeDam(RunCase& run)
{
    run.write("system/setParticlesDict", "geometry { tank { type polyline; points ((0 1.2 0) (0 0 0) (1.6 0 0) (1.6 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (0 0 0) (0.6 0.3 0); } );\n");
    run.write("system/controlDict", "endTime 0.3; deltaT 8e-3; maxDeltaT 8e-3; maxCo 1; maxPressureCo 1; checkpointInterval 0;\n"
                                    "writeControl timeStep; writeInterval 1; purgeWrite 0;");
    run.make();
}

} // namespace

TEST(StepRedo, answersARiseOfEnergyOnce)
{
    RunCase run(0.01);
    writeTank(run);
    run.start();
    for (int k = 0; k < 5; ++k) run.step();
    Step const normal = run.step(), spoilt = spoiltStep(run, {}, speedUp);
    expectBetween("spoilt step over the one before", spoilt.dt / normal.dt, 0.49, 0.551);
    Real longest = spoilt.dt;
    for (int k = 0; k < 20; ++k)
    {
        Step const next = run.step();
        EXPECT_LE(next.dt, 1.11 * longest);
        longest = std::max(longest, next.dt);
    }
    EXPECT_EQ(run.scene().guard().redone(StepGuard::Energy), 1);
    EXPECT_EQ(run.scene().guard().redone(), 1);
    EXPECT_EQ(run.scene().guard().kept(), 0);
    expectBetween("length 20 steps after a redo over that before", longest / normal.dt, 0.9, 1.2);
    expectBelow("kinetic energy 20 steps after a redo [J]", kineticEnergy(run.scene()), 0.05);
}

TEST(StepRedo, answersLimitedDisplacements)
{
    RunCase run(0.01);
    writeTank(run, "redoSteps { energyRise 0; }");
    run.start();
    for (int k = 0; k < 5; ++k) run.step();
    spoiltStep(run, [](Scene& scene) { particlesOf(scene).p[scene.particles().fluid().first + 300] += 1e6; }, {});
    for (int k = 0; k < 5; ++k) run.step();
    EXPECT_EQ(run.scene().guard().redone(StepGuard::Limiter), 1);
    EXPECT_EQ(run.scene().guard().redone(), 1);
    EXPECT_EQ(run.scene().fluid()->fluid().limited(), 0) << "displacements of an undone try count";
}

TEST(StepRedo, answersAParticleThatPassesTheWall)
{
    RunCase run(0.01);
    writeTank(run);
    run.start();
    for (int k = 0; k < 5; ++k) run.step();
    spoiltStep(run, {}, [](Scene& scene) {
        for (int const i : scene.particles().fluid())
            if (scene.particles().r[i].y() < 0.01 && std::abs(scene.particles().r[i].x() - 0.2) < 0.01)
                particlesOf(scene).r[i].y() -= 0.011;
    });
    EXPECT_EQ(run.scene().guard().redone(StepGuard::Wall), 1);
}

// All that a try has changed is as before: whether it was undone at its end or at its begin makes no difference to a bit.
TEST(StepRedo, leavesNoTrace)
{
    RunCase late(0.05), early(0.05);
    for (RunCase* run : {&late, &early})
    {
        writeWedge(*run);
        run->start();
        for (int k = 0; k < 60; ++k) run->step();
    }
    EXPECT_GT(late.scene().solids()->contacts()->contactCount(), 0u);
    for (int k = 0; k < 3; ++k)
    {
        spoiltStep(late, {}, speedUp);
        early.start().takeStep([&, tries = 0](Step const& step) mutable {
            early.start().moveBoundaries();
            early.start().updateNeighbours(step);
            if (tries++ == 0) fail(early.start());
            early.stages(step);
        });
        early.start().observe({late.scene().state().integer("time/step"), late.scene().state().real("time/value"), 1e-3, false});
    }
    EXPECT_EQ(late.scene().guard().redone(StepGuard::Energy), 3);
    EXPECT_EQ(early.scene().guard().redone(StepGuard::Failure), 3);
    expectBelow("blocks that differ after a redo", differences(late.scene().state(), early.scene().state()), 0);
}

TEST(StepRedo, triesThreeHalvesBeforeASolverEndsTheRun)
{
    RunCase run(0.02);
    writeTank(run);
    Scene& scene = run.start();
    run.step();
    int tries = 0;
    Step const step = scene.takeStep([&](Step const& one) {
        run.stages(one);
        if (++tries <= 3) fail(scene);
    });
    scene.observe(step);
    EXPECT_EQ(tries, 4);
    tries = 0;
    auto const never = [&](Step const& one) {
        run.stages(one);
        ++tries;
        fail(scene);
    };
    EXPECT_THROW(scene.takeStep(never), CaseError);
    EXPECT_EQ(tries, 4);
}

TEST(StepRedo, endsARunWhoseStepCollapses)
{
    RunCase run(0.02);
    writeTank(run);
    run.start();
    run.step();
    int steps = 0;
    std::string message;
    try
    {
        for (; steps < 200; ++steps) spoiltStep(run, fail, {});
    }
    catch (CaseError const& error)
    {
        message = error.what();
        EXPECT_EQ(error.code(), ExitCode::Solver);
    }
    EXPECT_NE(message.find("the time step collapsed"), std::string::npos) << message;
    expectBetween("steps, each halved, until a collapse is told", steps, 55, 75);
}

// Still water that settles gains a little; where next to nothing is allowed the run ends.
TEST(StepRedo, endsARunWhoseEnergyGoesOnRising)
{
    RunCase strict(0.02), usual(0.02);
    writeTank(strict, "redoSteps { energyGain 1e-9; }");
    writeTank(usual, "");
    std::string message;
    try
    {
        strict.run();
    }
    catch (CaseError const& error)
    {
        message = error.what();
        EXPECT_EQ(error.code(), ExitCode::Solver);
    }
    EXPECT_NE(message.find("goes on rising"), std::string::npos) << message;
    usual.run();
    expectBelow("still water: gain of energy", usual.scene().guard().gain(), 0.01);
}

TEST(StepRedo, onlyTellsWhereStepsAreFixedAndNothingWhereItIsOff)
{
    RunCase fixed(0.02), off(0.02);
    writeTank(fixed, "adjustTimeStep no;");
    writeTank(off, "redoSteps { active no; }");
    for (RunCase* run : {&fixed, &off})
    {
        run->start();
        for (int k = 0; k < 3; ++k) run->step();
        spoiltStep(*run, {}, speedUp);
        EXPECT_EQ(run->scene().guard().redone(), 0);
        EXPECT_EQ(run->scene().guard().kept(), run == &fixed ? 1 : 0);
    }
}

// A run that is broken off before, at and behind steps that were taken again ends with the same bytes.
TEST(StepRedo, goesOnWithTheSameBytes)
{
    RunCase unbroken(0.02);
    writeDam(unbroken);
    std::vector<std::int64_t> seams;
    std::int64_t redone = 0;
    unbroken.run([&](Scene const& scene, Step const& step) {
        if (scene.guard().redone() > redone) seams.insert(seams.end(), {step.number - 1, step.number});
        redone = scene.guard().redone();
    });
    State const end = unbroken.scene().state();
    expectBetween("dam break, dt x 4, 0.3 s: steps taken again", static_cast<Real>(redone), 2, 20);
    int same = 0;
    for (std::int64_t const seam : seams)
    {
        RunCase broken(0.02);
        broken.copyFrom(unbroken);
        for (auto const& entry : std::filesystem::directory_iterator(broken.root() / "checkpoint"))
            if (std::stoll(entry.path().filename().string()) > seam) std::filesystem::remove_all(entry.path());
        broken.run();
        same += sameBits(end, broken.scene().state());
    }
    auto const count = static_cast<Real>(seams.size());
    expectBetween("restarts around redone steps with the same bytes", same, count, count);
}

} // namespace mpsDem::test
