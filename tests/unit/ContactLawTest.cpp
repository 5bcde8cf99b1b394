#include <cmath>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "dem/ContactLaw.h"
#include "dem/ContactProperties.h"
#include "dem/PairStiffness.h"

namespace mpsDem {
namespace {

ContactMaterial material()
{
    ContactMaterial m;
    m.stiffnessPerArea = 1e8;
    m.effectiveModulus = 4e10;
    m.effectiveShear = 8e9;
    m.mu = 0.5;
    return m;
}

Contact contactAt(Real overlap, Vector const& velocity)
{
    Contact contact;
    contact.normal = Vector::UnitY();
    contact.overlap = overlap;
    contact.velocity = velocity;
    contact.area = 0.01;
    contact.radius = 0.01;
    contact.mass = 1;
    contact.fresh = false;
    return contact;
}

Contact evaluated(std::string const& law, ContactMaterial const& m, Contact contact, Real h)
{
    ContactDissipation dissipation;
    contactLaws().make(law, {}, m)->evaluate(std::span<Contact>(&contact, 1), h, dissipation);
    return contact;
}

} // namespace

TEST(ContactLaw, dampingRatioInvertsRestitution)
{
    for (Real const e : {0.01, 0.05, 0.1353352832366127, 0.2, 0.5, 0.9, 0.999}) EXPECT_NEAR(restitution(dampingRatio(e)), e, 1e-9);
    EXPECT_EQ(dampingRatio(1), 0);
    // Nearly elastic: the dashpot hardly pulls, so the familiar formula is approached.
    EXPECT_NEAR(dampingRatio(0.99) / (-std::log(0.99) / 3.14159265), 1, 0.01);
}

TEST(ContactLaw, linearSpring)
{
    Contact const contact = evaluated("linearSpringDashpot", material(), contactAt(1e-5, Vector::Zero()), 1e-6);
    EXPECT_NEAR(contact.normalForce.y(), 10, 1e-12); // k = 1e8 * 0.01
    EXPECT_EQ(contact.tangentialForce.norm(), 0);
    EXPECT_NEAR(contact.normalEnergy, 0.5 * 1e6 * 1e-10, 1e-18);
}

TEST(ContactLaw, hertzSpring)
{
    Contact const contact = evaluated("hertzMindlin", material(), contactAt(1e-6, Vector::Zero()), 1e-8);
    EXPECT_NEAR(contact.normalForce.y(), 4.0 / 3.0 * 4e10 * 0.1 * 1e-9, 1e-9);
    EXPECT_NEAR(contact.tangentialStiffness, 8 * 8e9 * std::sqrt(0.01 * 1e-6), 1e-3);
}

TEST(ContactLaw, dashpotNeverPulls)
{
    ContactMaterial m = material();
    m.zeta = 0.7;
    for (std::string const law : {"linearSpringDashpot", "hertzMindlin"})
        EXPECT_EQ(evaluated(law, m, contactAt(1e-7, {0, 3, 0}), 1e-7).normalForce.norm(), 0) << law;
}

// Two thirds of the way to the limit the spring holds k_t xi; beyond it the force is mu F_n against the motion and xi = mu F_n / k_t.
TEST(ContactLaw, sliderHoldsThenSlips)
{
    for (std::string const law : {"linearSpringDashpot", "hertzMindlin"})
    {
        Contact contact = evaluated(law, material(), contactAt(1e-6, Vector::Zero()), 1e-7);
        Real const limit = 0.5 * contact.normalForce.y();
        Real const xi = limit / contact.tangentialStiffness;
        contact.velocity = Vector(xi / 1.5 / 1e-7, 0, 0);
        contact = evaluated(law, material(), contact, 1e-7);
        EXPECT_NEAR(contact.tangentialForce.x() / limit, -1 / 1.5, 1e-9) << law;
        contact = evaluated(law, material(), contact, 1e-7);
        EXPECT_NEAR(contact.tangentialForce.x() / limit, -1, 1e-12) << law;
        EXPECT_NEAR(contact.slip.x() / xi, 1, 1e-9) << law;
    }
}

TEST(ContactLaw, unknownLawNamesTheKnownOnes)
{
    try
    {
        (void)contactLaws().make("linearSpring", {"constant/contactProperties", 14, "law"}, material());
        FAIL() << "not refused";
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        EXPECT_NE(std::string(error.what()).find("hertzMindlin, linearSpringDashpot"), std::string::npos) << error.what();
    }
}

// The weight on the longest side sinks in by maxOverlap, whatever the spacing.
TEST(ContactLaw, stiffnessFollowsMaxOverlap)
{
    ContactProperties properties;
    properties.impactSpeed = 0;
    for (Real const spacing : {0.04, 0.01})
    {
        Real const k = stiffnessPerArea(properties, {140, 0.4, spacing, 0.55, false});
        EXPECT_NEAR(140 * 9.81 / (k * 0.4), 1e-3 * spacing, 1e-12);
    }
    properties.impactSpeed = 1;
    Real const k = stiffnessPerArea(properties, {140, 0.4, 0.02, 0.55, false});
    EXPECT_NEAR(std::sqrt(140 / (k * 0.01 * 0.55)), 0.05 * 0.02, 1e-9); // one corner stops the body
}

TEST(ContactLaw, pairsOverrideInEitherOrder)
{
    Dictionary const dict = Dictionary::fromText("mu 0.4; e 0.3; pairs { \"slide:ramp\" { mu 0.0105; } \"floor:slide\" { e 0.1; } }");
    ContactProperties const common = ContactProperties::readCommon(dict);
    EXPECT_EQ(ContactProperties::readPair(dict, common, "slide", "ramp").mu, 0.0105);
    EXPECT_EQ(ContactProperties::readPair(dict, common, "slide", "ramp").e, 0.3);
    EXPECT_EQ(ContactProperties::readPair(dict, common, "slide", "floor").e, 0.1);
    EXPECT_EQ(ContactProperties::readPair(dict, common, "slide", "wall").mu, 0.4);
    Dictionary const twice = Dictionary::fromText("mu 0.4; pairs {\n \"a:b\" { mu 0.1; }\n \"b:a\" { mu 0.2; }\n }");
    EXPECT_THROW((void)ContactProperties::readPair(twice, common, "a", "b"), CaseError);
    EXPECT_THROW((void)ContactProperties::readCommon(Dictionary::fromText("e 0.3;")), CaseError);
    EXPECT_THROW((void)ContactProperties::readCommon(Dictionary::fromText("mu -0.3;")), CaseError);
    EXPECT_THROW((void)ContactProperties::readCommon(Dictionary::fromText("mu 0.3; stiffness constant;")), CaseError);
}

} // namespace mpsDem
