#include "core/Errors.h"
#include "dem/LinearSpringDashpot.h"
#include "support/ContactScene.h"
#include "support/FunctionObjectScene.h"

/// A program that links the libraries may add models of its own to their registries before it reads a case.

namespace mpsDem::test {

namespace {

/// Four times as stiff as the law that it is made of.
class StiffLaw final : public ContactLaw
{
public:
    explicit StiffLaw(ContactMaterial material) : law_(stiffer(material)) {}

    void evaluate(std::span<Contact> contacts, Real h, ContactDissipation& dissipation) const override
    {
        law_.evaluate(contacts, h, dissipation);
    }
    [[nodiscard]] Real normalStiffness(Contact const& c, Real overlap) const override { return law_.normalStiffness(c, overlap); }
    [[nodiscard]] Real tangentialStiffness(Contact const& c, Real overlap) const override { return law_.tangentialStiffness(c, overlap); }
    [[nodiscard]] Real impactOverlap(Contact const& c, Real speed) const override { return law_.impactOverlap(c, speed); }

private:
    static ContactMaterial stiffer(ContactMaterial material)
    {
        material.stiffnessPerArea *= 4;
        return material;
    }
    LinearSpringDashpot law_;
};

/// Sub-steps of 0.1 s for a box on a floor.
int subSteps(std::string const& law)
{
    ContactScene scene;
    scene.surfaces = {floorLine()};
    scene.addBox("box", 0.5, 0.2, 1000, {0, 0.1, 0});
    scene.build("mu 0.3; stiffness constant; normalStiffness 1e7; law " + law + ";");
    return scene.contact->subSteps(scene.pointers, 0.1);
}

/// Counts its calls.
struct Counter final : FunctionObject
{
    explicit Counter(int& counted) : count(counted) {}
    void execute(Step const&) override { ++count; }
    void write(Step const&) override {}
    int& count;
};

} // namespace

TEST(Registry, TakesAContactLawFromOutside)
{
    contactLaws().add("stiffLaw", [](ContactMaterial const& material) { return std::make_unique<StiffLaw>(material); });
    // The sub-step goes with the square root of the stiffness.
    EXPECT_NEAR(subSteps("stiffLaw"), 2 * subSteps("linearSpringDashpot"), 2);
    EXPECT_GT(subSteps("linearSpringDashpot"), 50);
}

TEST(Registry, TakesAFunctionObjectFromOutside)
{
    int count = 0;
    functionObjectRegistry().add(
        "counter", [&](std::string const&, Dictionary const&, RunContext const&) { return std::make_unique<Counter>(count); });
    FunctionObjectScene const scene({2, 0.1, 1});
    RunContext const context = scene.context();
    FunctionObjects objects(Dictionary::fromText("mine { type counter; executeInterval 2; writeControl none; }"), context);
    for (int step = 1; step <= 10; ++step) objects.execute({step, 0.1 * step, 0.1, false});
    EXPECT_EQ(count, 5);
}

TEST(Registry, NamesWhatItHoldsAndTheNearest)
{
    try
    {
        static_cast<void>(contactLaws().make("hertzMindlim", Location{"constant/contactProperties", 3, {}}, ContactMaterial()));
        FAIL() << "the word was taken";
    }
    catch (CaseError const& error)
    {
        std::string const text = error.what();
        EXPECT_NE(text.find("constant/contactProperties:3"), std::string::npos) << text;
        EXPECT_NE(text.find("did you mean hertzMindlin?"), std::string::npos) << text;
    }
}

} // namespace mpsDem::test
