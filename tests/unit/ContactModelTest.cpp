#include <sstream>

#include "core/Log.h"
#include "support/ContactScene.h"

namespace mpsDem::test {

namespace {

ContactScene boxOver(Real gap, Real speed = 0)
{
    ContactScene scene;
    scene.surfaces = {floorLine()};
    scene.addBox("box", 0.2, 0.1, 1000, {0, 0.05 + gap, 0}).setVelocity({0, -speed, 0}, Vector::Zero());
    return scene;
}

} // namespace

TEST(ContactModel, oneSubStepWhereNothingCanTouch)
{
    ContactScene scene = boxOver(0.0055);
    scene.build("mu 0.3;");
    EXPECT_EQ(scene.contact->subSteps(scene.pointers, 1e-4), 1);
    EXPECT_GT(scene.contact->subSteps(scene.pointers, 1e-2), 1); // may fall 1 mm meanwhile
    scene.pointers[0]->setVelocity({0, -11, 0}, Vector::Zero());
    EXPECT_GT(scene.contact->subSteps(scene.pointers, 1e-4), 1);
}

// omega^2 = k A / m for the face, h = pi / (32 omega); the rotation of the box needs no smaller one than its corners allow.
TEST(ContactModel, subStepsFollowTheContact)
{
    ContactScene scene = boxOver(0);
    scene.build("mu 0.3; stiffness constant; normalStiffness 1e9;");
    Real const byFace = 1e-3 * 32 / std::numbers::pi * std::sqrt(1e9 * 0.2 / 20);
    int const count = scene.contact->subSteps(scene.pointers, 1e-3);
    EXPECT_GE(count, std::ceil(byFace));
    EXPECT_LE(count, std::ceil(2 * byFace));
    EXPECT_EQ(scene.contact->subSteps(scene.pointers, 1e-3), count);
}

TEST(ContactModel, tooManySubStepsAreAnError)
{
    ContactScene scene = boxOver(0);
    scene.build("mu 0.3; stiffness constant; normalStiffness 1e18;");
    EXPECT_THROW((void)scene.contact->subSteps(scene.pointers, 1e-2), CaseError);
}

TEST(ContactModel, overlapAtTheStartIsRefused)
{
    ContactScene scene = boxOver(-0.0061); // 0.305 of the spacing
    EXPECT_THROW(scene.build("mu 0.3;"), CaseError);
}

TEST(ContactModel, restingBoxCarriesItsWeight)
{
    ContactScene scene = boxOver(0);
    scene.pointers[0]->setGravity({0, -9.81, 0});
    scene.build("mu 0.3; e 0.1;");
    for (int i = 0; i < 100; ++i) scene.step(1e-3);
    EXPECT_NEAR(scene.pointers[0]->meanContactNormal().force.y() / (20 * 9.81), 1, 1e-6);
    EXPECT_LT(scene.pointers[0]->velocity().norm(), 1e-9);
    EXPECT_LE(scene.contact->maxOverlap(), 1e-3 * scene.spacing);
    EXPECT_GT(scene.contact->maxOverlap(), 0);
}

// A modulus is given that the stiffness is not made of: one line of the report says so, with its place.
TEST(ContactModel, saysOnceThatAModulusHasNoEffect)
{
    auto const reportOf = [](std::string const& dictionary) {
        ContactScene scene;
        scene.surfaces = {floorLine("floor"), Polyline("bank", {{5, 5, 0}, {6, 5, 0}}, false, Polyline::FluidSide::Left)};
        scene.addBox("box", 0.2, 0.1, 1000, {0, 0.05, 0});
        scene.build(dictionary);
        std::ostringstream text;
        scene.contact->report(text, scene.pointers);
        return text.str();
    };
    std::string const note = "contact: youngsModulus (text:2) has no effect with stiffness maxOverlap and law linearSpringDashpot\n";
    std::string const idle = reportOf("mu 0.1;\nyoungsModulus 1e7;");
    std::size_t const at = idle.find(note);
    ASSERT_NE(at, std::string::npos) << idle;
    EXPECT_EQ(idle.find("no effect", at + note.size()), std::string::npos) << idle;
    for (std::string const used :
         {"mu 0.1; youngsModulus 1e7; stiffness fromModulus;", "mu 0.1; youngsModulus 1e7; law hertzMindlin;", "mu 0.1;"})
        EXPECT_EQ(reportOf(used).find("no effect"), std::string::npos) << used;
}

// In a valley of two sides at 45 degrees a box standing on its corner touches both; each carries m g / sqrt 2, not more. The valley is one
// surface, or two of which one ends on the other.
TEST(ContactModel, boxInAValleyHasNoDoubleForce)
{
    auto const side = Polyline::FluidSide::Left;
    std::vector<std::vector<Polyline>> const valleys = {
        {Polyline("valley", {{-1, 1, 0}, {0, 0, 0}, {1, 1, 0}}, false, side)},
        {Polyline("ramp", {{-1, 1, 0}, {0, 0, 0}}, false, side), Polyline("bank", {{-1, -1, 0}, {1, 1, 0}}, false, side)}};
    for (std::vector<Polyline> const& valley : valleys)
    {
        ContactScene scene;
        scene.gravity = Vector(0, -9.81, 0);
        scene.surfaces = valley;
        RigidBody& box = scene.addBox("box", 0.1, 0.1, 1000, {0, 0.1 / std::numbers::sqrt2, 0}, std::numbers::pi / 4);
        scene.build("mu 0; e 0.1;");
        for (int i = 0; i < 200; ++i) scene.step(1e-3);
        Real sum = 0;
        for (ContactPair const& pair : scene.contact->pairs())
            for (Contact const& contact : pair.contacts()) sum += contact.normalForce.norm();
        EXPECT_NEAR(sum / (10 * 9.81 * std::numbers::sqrt2), 1, 1e-6);
        EXPECT_NEAR(box.contactNormal.force.y() / (10 * 9.81), 1, 1e-6);
        EXPECT_LT(box.velocity().norm(), 1e-6);
        EXPECT_LT(std::abs(box.centre().x()), 1e-9);
    }
}

// A block slides over the joint of a floor and a second floor of another name: both touch, and the weight is carried once.
TEST(ContactModel, twoSurfacesShareTheWeight)
{
    ContactScene scene;
    scene.gravity = Vector(0, -9.81, 0);
    scene.surfaces = {Polyline("left", {{-2, 0, 0}, {0, 0, 0}}, false, Polyline::FluidSide::Left),
                      Polyline("right", {{0, 0, 0}, {2, 0, 0}}, false, Polyline::FluidSide::Left)};
    RigidBody& box = scene.addBox("box", 0.2, 0.1, 1000, {-0.3, 0.05, 0});
    box.setVelocity({1, 0, 0}, Vector::Zero());
    scene.build("mu 0; e 0.1;");
    for (int i = 0; i < 600; ++i) scene.step(1e-3);
    EXPECT_NEAR(box.centre().x(), 0.3, 1e-9);
    EXPECT_NEAR(box.velocity().x(), 1, 1e-9);
    EXPECT_LT(std::abs(box.angularVelocity().z()), 1e-6);
}

TEST(ContactModel, stopperStopsItsBodyOnly)
{
    ContactScene scene;
    RigidBody& a = scene.addBox("a", 0.1, 0.1, 1000, {0, 0, 0});
    RigidBody& b = scene.addBox("b", 0.1, 0.1, 1000, {0, 1, 0});
    a.setVelocity({1, 0, 0}, Vector::Zero());
    b.setVelocity({1, 0, 0}, Vector::Zero());
    scene.build("mu 0.3; stoppers { foot { type stopper; body a; point (0.1 0 0); normal (-1 0 0); e 0.4; } }");
    for (int i = 0; i < 100; ++i) scene.step(1e-3);
    EXPECT_NEAR(a.velocity().x(), -0.4, 0.004);
    EXPECT_EQ(b.velocity().x(), 1);
}

TEST(ContactModel, latchLocksAndKeepsImpulseAndEnergy)
{
    muteLog(true);
    ContactScene scene;
    RigidBody& slide = scene.addBox("slide", 0.1, 0.1, 1000, {0, 0, 0});
    slide.setVelocity({1, -0.5, 0}, Vector::Zero());
    Real const energy = slide.kineticEnergy();
    scene.build("mu 0.3; stoppers { foot { type latch; body slide; point (0.1 0 0); normal (-1 0 0); } }");
    for (int i = 0; i < 100; ++i) scene.step(1e-3);
    muteLog(false);
    EXPECT_TRUE(slide.locked());
    EXPECT_TRUE(scene.contact->latches()[0].closed());
    EXPECT_NEAR((scene.contact->latches()[0].impulse() - Vector(-10, 5, 0)).norm(), 0, 1e-9);
    EXPECT_NEAR(scene.contact->latchedEnergy(), energy, 1e-9);
    State state;
    scene.contact->save(state);
    scene.build("mu 0.3; stoppers { foot { type latch; body slide; point (0.1 0 0); normal (-1 0 0); } }");
    EXPECT_EQ(scene.contact->latchedEnergy(), 0);
    scene.contact->load(state);
    EXPECT_NEAR(scene.contact->latchedEnergy(), energy, 1e-9);
    EXPECT_NEAR(slide.centre().x(), 0.05, 2e-3);
    EXPECT_EQ(scene.contact->subSteps(scene.pointers, 1e-3), 1);
}

TEST(ContactModel, stopperOfAnUnknownBodyIsRefused)
{
    ContactScene scene = boxOver(0.1);
    EXPECT_THROW(scene.build("mu 0.3; stoppers { foot { type latch; body bax; point (0 0 0); normal (0 1 0); } }"), CaseError);
}

// A slide with stretched springs is saved, loaded into a new scene and goes on bit by bit.
TEST(ContactModel, historySurvivesSaveAndLoadBitwise)
{
    auto const make = [] {
        ContactScene scene;
        scene.gravity = Vector(3, -9.81, 0);
        scene.surfaces = {floorLine()};
        scene.addBox("box", 0.2, 0.1, 1000, {0, 0.05, 0}).setVelocity({0.01, 0, 0}, {0, 0, 0.01});
        scene.addBall("ball", 0.05, 500, {0.151, 0.0501, 0}).setVelocity({-0.3, 0, 0}, {0, 0, 5});
        scene.build("mu 0.4; e 0.3;");
        return scene;
    };
    ContactScene whole = make();
    for (int i = 0; i < 8; ++i) whole.step(1e-3);
    State state;
    for (RigidBody const* body : whole.pointers) body->save(state);
    whole.contact->save(state);
    ASSERT_GT(whole.contact->contactCount(), 0u);
    ASSERT_GT(whole.contact->elasticEnergy(), 0);

    ContactScene again = make();
    for (RigidBody* body : again.pointers) body->load(state);
    again.contact->load(state);
    again.time = whole.time;
    EXPECT_EQ(again.contact->elasticEnergy(), whole.contact->elasticEnergy());
    for (int i = 0; i < 8; ++i)
    {
        whole.step(1e-3);
        again.step(1e-3);
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
        EXPECT_EQ(whole.pointers[i]->centre(), again.pointers[i]->centre());
        EXPECT_EQ(whole.pointers[i]->velocity(), again.pointers[i]->velocity());
        EXPECT_EQ(whole.pointers[i]->angularVelocity(), again.pointers[i]->angularVelocity());
    }
    EXPECT_EQ(whole.contact->dissipatedEnergy(), again.contact->dissipatedEnergy());
}

TEST(ContactModel, reportNamesEachPair)
{
    ContactScene scene = boxOver(0);
    scene.build("mu 0.3;");
    std::ostringstream text;
    scene.contact->report(text, scene.pointers);
    EXPECT_NE(text.str().find("contact box:floor: linearSpringDashpot, mu 0.3"), std::string::npos) << text.str();
}

} // namespace mpsDem::test
