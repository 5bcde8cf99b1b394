#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/Dictionary.h"

namespace {

using mpsDem::Dictionary;
using mpsDem::Real;
using mpsDem::Vector;
using Reals = std::vector<Real>;

TEST(DictionaryGrammar, readsKeywordsValuesAndNestedDictionaries)
{
    Dictionary const dictionary = Dictionary::fromText(R"(
        // a comment
        deltaT 0.001;   /* another
        one */ endTime 3;
        solvers { p { tolerance 1e-6; } }
        div(phi,U) "Gauss linear";
    )");
    EXPECT_EQ(dictionary.get<Real>("deltaT"), 0.001);
    EXPECT_EQ(dictionary.get<int>("endTime"), 3);
    EXPECT_EQ(dictionary.subDict("solvers").subDict("p").get<Real>("tolerance"), 1e-6);
    EXPECT_EQ(dictionary.get<std::string>("div(phi,U)"), "Gauss linear");
    EXPECT_EQ(dictionary.where("endTime").line, 4);
    EXPECT_EQ(dictionary.subDict("solvers").subDict("p").where("tolerance").entry, "solvers.p.tolerance");
    EXPECT_EQ(dictionary.keys(), (std::vector<std::string>{"deltaT", "endTime", "solvers", "div(phi,U)"}));
    EXPECT_EQ(dictionary.dictKeys(), std::vector<std::string>{"solvers"});
}

TEST(DictionaryGrammar, takesTheSixSwitches)
{
    for (char const* word : {"true", "on", "yes"}) EXPECT_TRUE(Dictionary::fromText(std::string("a ") + word + ";").get<bool>("a"));
    for (char const* word : {"false", "off", "no"}) EXPECT_FALSE(Dictionary::fromText(std::string("a ") + word + ";").get<bool>("a"));
}

TEST(DictionaryGrammar, readsNumbersInEveryDecimalForm)
{
    Dictionary const dictionary = Dictionary::fromText("a (1 -2 .5 -.5 3. 1e3 1E+3 2.5e-3 0.1 +4 1e-400);");
    EXPECT_EQ(dictionary.get<Reals>("a"), (Reals{1, -2, 0.5, -0.5, 3, 1000, 1000, 0.0025, 0.1, 4, 0}));
    EXPECT_EQ(Dictionary::fromText("seed 9007199254740993;").get<std::int64_t>("seed"), 9007199254740993);
}

TEST(DictionaryGrammar, readsListsInEveryForm)
{
    Dictionary const dictionary = Dictionary::fromText(R"(
        plain (1 2 3); counted 3(1 2 3); spaced 3 ( 1 2 3 ); repeated 3{7}; empty (); none 0();
        typed List<scalar> 3(1 2 3); field nonuniform List<scalar> 3(1 2 3); single uniform 4;
        points ((0 0 0) (1 2 3)); faces 2(3(0 1 2) (3 4 5)); names (slide "end stop");
        velocities nonuniform List<vector> 2{(1 0 0)};
    )");
    for (char const* key : {"plain", "counted", "spaced", "typed", "field"}) EXPECT_EQ(dictionary.get<Reals>(key), (Reals{1, 2, 3})) << key;
    EXPECT_EQ(dictionary.get<Reals>("repeated"), (Reals{7, 7, 7}));
    EXPECT_TRUE(dictionary.get<Reals>("empty").empty());
    EXPECT_TRUE(dictionary.get<Reals>("none").empty());
    EXPECT_EQ(dictionary.get<Reals>("single"), Reals{4});
    EXPECT_EQ(dictionary.get<Real>("single"), 4);
    EXPECT_EQ(dictionary.get<std::vector<Vector>>("points"), (std::vector<Vector>{{0, 0, 0}, {1, 2, 3}}));
    EXPECT_EQ(dictionary.get<std::vector<std::vector<int>>>("faces"), (std::vector<std::vector<int>>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(dictionary.get<std::vector<std::string>>("names"), (std::vector<std::string>{"slide", "end stop"}));
    EXPECT_EQ(dictionary.get<std::vector<Vector>>("velocities"), (std::vector<Vector>{{1, 0, 0}, {1, 0, 0}}));
}

TEST(DictionaryGrammar, readsVectorsAndTensors)
{
    Dictionary const dictionary = Dictionary::fromText("g (0 -9.81 0); u uniform (1 2 3); r (1 2 3 4 5 6 7 8 9);");
    EXPECT_EQ(dictionary.get<Vector>("g"), Vector(0, -9.81, 0));
    EXPECT_EQ(dictionary.get<Vector>("u"), Vector(1, 2, 3));
    mpsDem::Tensor const tensor = dictionary.get<mpsDem::Tensor>("r");
    EXPECT_EQ(tensor(0, 1), 2);
    EXPECT_EQ(tensor(2, 0), 7);
}

TEST(DictionaryGrammar, readsDimensionedValuesInThreeForms)
{
    std::vector<int> const viscosity = {0, 2, -1, 0, 0, 0, 0};
    for (char const* value : {"1e-6", "[0 2 -1 0 0 0 0] 1e-6", "nu [0 2 -1 0 0 0 0] 1e-6", "[0 2 -1 0 0] 1e-6"})
        EXPECT_EQ(Dictionary::fromText(std::string("nu ") + value + ";").getDimensioned("nu", viscosity), 1e-6) << value;
    Dictionary const gravity = Dictionary::fromText("g [0 1 -2 0 0 0 0] (0 -9.81 0);");
    EXPECT_EQ(gravity.getDimensionedVector("g", {0, 1, -2, 0, 0, 0, 0}), Vector(0, -9.81, 0));
}

TEST(DictionaryGrammar, readsStringsWithQuotesAndVerbatimText)
{
    Dictionary const dictionary = Dictionary::fromText("a \"say \\\"slide\\\" // twice\"; b #{ x;\n y #}; c 1;");
    EXPECT_EQ(dictionary.get<std::string>("a"), "say \"slide\" // twice");
    EXPECT_EQ(dictionary.entryText("b"), "#{ x;\n y #}");
    EXPECT_EQ(dictionary.where("c").line, 2);
}

TEST(DictionaryGrammar, mergesDuplicateDictionaries)
{
    Dictionary const dictionary = Dictionary::fromText("a { x 1; } b 2; a { y 3; sub { z 4; } }");
    EXPECT_EQ(dictionary.keys(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(dictionary.subDict("a").keys(), (std::vector<std::string>{"x", "y", "sub"}));
}

TEST(DictionaryGrammar, findsTheExactKeywordFirstAndThenTheLastPattern)
{
    Dictionary const dictionary = Dictionary::fromText(R"-("p.*" 1; "(p|U)" 2; p 3; "(?i).*wall" 4;)-");
    EXPECT_EQ(dictionary.get<int>("p"), 3);
    EXPECT_EQ(dictionary.get<int>("pFinal"), 1);
    EXPECT_EQ(dictionary.get<int>("U"), 2);
    EXPECT_EQ(dictionary.get<int>("lowerWALL"), 4);
    EXPECT_FALSE(dictionary.found("Up"));
    Dictionary const pairs = Dictionary::fromText(R"(pairs { "slide:ramp" { mu 0.0105; } "slide:.*" { mu 0.2; } })").subDict("pairs");
    EXPECT_EQ(pairs.subDict("slide:ramp").get<Real>("mu"), 0.0105);
    EXPECT_EQ(pairs.subDict("slide:floor").get<Real>("mu"), 0.2);
}

TEST(DictionaryGrammar, ignoresByteOrderMarkAndCarriageReturns)
{
    Dictionary const dictionary = Dictionary::fromText("\xEF\xBB\xBF// file\r\ndeltaT 1;\r\nname \"Gl\xC3\xA4rnisch\";\r\n");
    EXPECT_EQ(dictionary.get<int>("deltaT"), 1);
    EXPECT_EQ(dictionary.where("deltaT").line, 2);
    EXPECT_EQ(dictionary.get<std::string>("name"), "Gl\xC3\xA4rnisch");
}

TEST(DictionaryGrammar, readsListsOfDictionaries)
{
    Dictionary const dictionary = Dictionary::fromText(R"(
        depth 2;
        regions ( boxToParticle { box (0 0 0) (1 $depth 1); fieldValues ( rho 1000 ); } { name ramp; sub { x 1; } } );
        walls ();
    )");
    auto const regions = dictionary.getDictList("regions");
    ASSERT_EQ(regions.size(), 2U);
    EXPECT_EQ(regions[0].first, "boxToParticle");
    EXPECT_EQ(regions[0].second.entryText("box"), "( 0 0 0 ) ( 1 2 1 )");
    EXPECT_EQ(regions[1].first, "");
    EXPECT_EQ(regions[1].second.get<std::string>("name"), "ramp");
    EXPECT_EQ(regions[1].second.where("name").line, 3);
    EXPECT_TRUE(dictionary.getDictList("walls").empty());
}

} // namespace
