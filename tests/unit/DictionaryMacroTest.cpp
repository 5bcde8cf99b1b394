#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/Dictionary.h"

namespace {

using mpsDem::CaseError;
using mpsDem::Dictionary;
using mpsDem::Real;

TEST(DictionaryMacro, standsForAnEntryHereOrFurtherOut)
{
    Dictionary const dictionary = Dictionary::fromText(R"(
        a 1; b { a 2; here $a; same $.a; c { outer $a; up $..a; top $...a; root $:a; } }
        down $b.here; braced ${b.c.up}; slash ${/b/c/top}; list (${a} $b.a);
    )");
    Dictionary const b = dictionary.subDict("b");
    EXPECT_EQ(b.get<int>("here"), 2);
    EXPECT_EQ(b.get<int>("same"), 2);
    EXPECT_EQ(b.subDict("c").get<int>("outer"), 2);
    EXPECT_EQ(b.subDict("c").get<int>("up"), 2);
    EXPECT_EQ(b.subDict("c").get<int>("top"), 1);
    EXPECT_EQ(b.subDict("c").get<int>("root"), 1);
    EXPECT_EQ(dictionary.get<int>("down"), 2);
    EXPECT_EQ(dictionary.get<int>("braced"), 2);
    EXPECT_EQ(dictionary.get<int>("slash"), 1);
    EXPECT_EQ(dictionary.get<std::vector<int>>("list"), (std::vector<int>{1, 2}));
}

TEST(DictionaryMacro, takesWholeListsAndKeysWithDots)
{
    Dictionary const dictionary = Dictionary::fromText("alpha.water 1; origin (1 2 3); a $alpha.water; points ($origin (4 5 6));");
    EXPECT_EQ(dictionary.get<int>("a"), 1);
    EXPECT_EQ(dictionary.get<std::vector<mpsDem::Vector>>("points").front(), mpsDem::Vector(1, 2, 3));
}

TEST(DictionaryMacro, mergesADictionaryAndLaterEntriesReplaceItsOwn)
{
    Dictionary const dictionary =
        Dictionary::fromText("p { tolerance 1e-6; relTol 0.1; sub { x 1; } } pFinal { $p; relTol 0; sub { y 2; } }");
    Dictionary const last = dictionary.subDict("pFinal");
    EXPECT_EQ(last.get<Real>("tolerance"), 1e-6);
    EXPECT_EQ(last.get<Real>("relTol"), 0);
    EXPECT_EQ(last.subDict("sub").keys(), (std::vector<std::string>{"x", "y"}));
    EXPECT_EQ(last.subDict("sub").name(), "pFinal.sub");
    EXPECT_EQ(dictionary.subDict("p").get<Real>("relTol"), 0.1);
    EXPECT_EQ(Dictionary::fromText("\"p.*\" { x 3; } U { $p; }").subDict("U").get<int>("x"), 3);
}

Real evaluated(std::string const& expression)
{
    return Dictionary::fromText("H 0.8; L { x -2; } a #eval{ " + expression + " };").get<Real>("a");
}

TEST(DictionaryMacro, evaluatesArithmeticInDoublePrecision)
{
    EXPECT_EQ(evaluated("1 + 2*3"), 7);
    EXPECT_EQ(evaluated("1/3"), 1.0 / 3);
    EXPECT_EQ(evaluated("7 % 4 + 2.5 % 2"), 3.5);
    EXPECT_EQ(evaluated("-3 % 2"), -1);
    EXPECT_EQ(evaluated("2*pi()"), 2 * std::numbers::pi);
    EXPECT_NEAR(evaluated("sin(degToRad(30))"), 0.5, 1e-15);
    EXPECT_EQ(evaluated("2 > 1 ? 5 : 6"), 5);
    EXPECT_EQ(evaluated("true && !false"), 1);
    EXPECT_EQ(evaluated("sqr(3) + mag(-3) + pow(2,3) + hypot(3,4) + cbrt(27) + floor(2.5) + ceil(2.5) + round(2.7)"), 36);
    EXPECT_EQ(evaluated("sign(-2) + pos(0) + pos0(0) + neg(0) + neg0(0)"), 1);
    EXPECT_EQ(evaluated("max(1, 2, 3) - min(1, 2, 3)"), 2);
    EXPECT_EQ(evaluated("1 // one\n + /* two */ 2"), 3);
}

TEST(DictionaryMacro, evaluatesWithMacrosOfFullPrecision)
{
    EXPECT_EQ(evaluated("$H/2"), 0.4);
    EXPECT_EQ(evaluated("1 - $L.x"), 3);
    EXPECT_EQ(evaluated("${L.x}^2"), 4);
    EXPECT_EQ(Dictionary::fromText("t 0.1; a #eval{ 3*$t }; b #eval{ $a - 3*0.1 };").get<Real>("b"), 0);
    EXPECT_EQ(Dictionary::fromText("n #eval \"2*4\"; m #eval #{ 3\n+ 1 #};").get<int>("n"), 8);
    EXPECT_EQ(Dictionary::fromText("origin (#eval{ 1+1 } 0 #eval{ 2*2 });").get<mpsDem::Vector>("origin"), mpsDem::Vector(2, 0, 4));
}

TEST(DictionaryMacro, namesTheNearestEntryWhereNoneIsFound)
{
    try
    {
        Dictionary::fromText("waterDepth 0.8;\nh $waterDeph;", "system/controlDict");
        FAIL();
    }
    catch (CaseError const& error)
    {
        std::string const text = error.what();
        EXPECT_NE(text.find("system/controlDict:2: the macro $waterDeph stands for no entry"), std::string::npos) << text;
        EXPECT_NE(text.find("did you mean $waterDepth?"), std::string::npos) << text;
    }
}

} // namespace
