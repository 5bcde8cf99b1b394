#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "support/FunctionObjectScene.h"

namespace mpsDem {
namespace {

/// What is said about these functions; empty where they are fine.
std::string complaint(std::string const& text, RunContext const& context)
{
    try
    {
        Dictionary const dict = Dictionary::fromText(text, "controlDict");
        FunctionObjects const objects(dict, context);
        dict.requireAllRead();
    }
    catch (CaseError const& error)
    {
        return error.what();
    }
    return {};
}

/// Runs steps of 0.1 s from step `first` to 20 as one run that starts there.
void run(FunctionObjectScene const& scene, std::string const& text, int first)
{
    RunContext const context = scene.context(0.1 * (first - 1));
    FunctionObjects objects(Dictionary::fromText(text), context);
    for (int k = first; k <= 20; ++k) objects.execute({k, 0.1 * k, 0.1, k % 10 == 0});
}

TEST(FunctionObjects, UnknownTypesAndKeysAreErrorsWithTheNearestName)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    RunContext const context = scene.context();
    EXPECT_NE(complaint("gauges { type interfaceHight; }", context).find("did you mean interfaceHeight"), std::string::npos);
    EXPECT_NE(complaint("energy { type energyBudget; writeIntervall 2; }", context).find("writeInterval"), std::string::npos);
    EXPECT_NE(complaint("\"../../energy\" { type energyBudget; }", context).find("name of a file"), std::string::npos);
    EXPECT_EQ(complaint("energy { type energyBudget; enabled no; timeStart 1; timeEnd 2; log true; }", context), "");
}

TEST(FunctionObjects, SpecimenNamesEveryTypeAndOnlyKnownKeys)
{
    FunctionObjectScene scene({2, 0.1, 1});
    auto points = scene.block(20, 10);
    for (int j = 0; j < 15; ++j) points.push_back({Vector(-0.05, 0.1 * j + 0.05, 0), ParticleType::Wall, Vector::UnitX()});
    scene.place(points);
    scene.wallNames = {"ramp", "tank"};
    MassProperties mass;
    mass.mass = 5;
    scene.bodies.push_back(std::make_unique<RigidBody>("slide", mass, Vector(0, 3, 0), Quaternion::Identity()));
    RunContext const context = scene.context();
    std::filesystem::path const folder = std::filesystem::path(MPSDEM_ETC) / "caseDicts";
    Dictionary const specimen = Dictionary::fromFile(folder / "functionObjects", folder);
    EXPECT_NO_THROW(FunctionObjects(specimen, context));
    EXPECT_NO_THROW(specimen.requireAllRead());
    std::set<std::string> types;
    for (std::string const& name : specimen.dictKeys()) types.insert(specimen.subDict(name).get<std::string>("type"));
    for (std::string const& type : functionObjectRegistry().names()) EXPECT_TRUE(types.count(type)) << type;
}

TEST(FunctionObjects, AnAbsentEffectIsAnError)
{
    FunctionObjectScene const scene({2, 0.1, 1});
    RunContext const context = scene.context();
    EXPECT_NE(complaint("a { type probes; probeLocations ((0 0 0)); }", context).find("fluid"), std::string::npos);
    EXPECT_NE(complaint("a { type sixDoFRigidBodyState; }", context).find("rigid bodies"), std::string::npos);
}

TEST(FunctionObjects, ActAtTheSameTimesAfterARestart)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    std::string const text = "byTime { type energyBudget; writeControl runTime; writeInterval 0.3; timeEnd 1.25; } "
                             "byStep { type energyBudget; writeControl timeStep; writeInterval 3; } "
                             "byWrite { type energyBudget; writeControl writeTime; }";
    run(scene, text, 1);
    run(scene, text, 8);
    for (std::string const name : {"byTime", "byStep", "byWrite"})
    {
        std::vector<Real> whole = scene.table(name + "/0/energy.dat").column("Time");
        std::vector<Real> const rest = scene.table(name + "/0.7/energy.dat").column("Time");
        whole.erase(whole.begin(), std::find_if(whole.begin(), whole.end(), [](Real t) { return t > 0.75; }));
        EXPECT_EQ(whole, rest) << name;
    }
    EXPECT_EQ(scene.table("byTime/0/energy.dat").rows(), 4u); // 0.3, 0.6, 0.9, 1.2
    EXPECT_EQ(scene.table("byWrite/0/energy.dat").rows(), 2u);
}

TEST(FunctionObjects, StepsMeetAdjustableTimesAndThoseOfProfiles)
{
    FunctionObjectScene scene({2, 0.1, 1});
    scene.place(scene.block(20, 10));
    RunContext const context = scene.context();
    FunctionObjects const objects(Dictionary::fromText("e { type energyBudget; writeControl adjustable; writeInterval 0.4; } "
                                                       "p { type freeSurfaceProfile; times (0.5); }"),
                                  context);
    EXPECT_DOUBLE_EQ(objects.nextTime(0), 0.4);
    EXPECT_DOUBLE_EQ(objects.nextTime(0.4), 0.5);
    EXPECT_DOUBLE_EQ(objects.nextTime(0.5), 0.8);
    FunctionObjects const none(Dictionary(), context);
    EXPECT_TRUE(std::isinf(none.nextTime(0)));
}

} // namespace
} // namespace mpsDem
