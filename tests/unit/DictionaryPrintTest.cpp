#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/Dictionary.h"

namespace {

using mpsDem::Dictionary;

// The expected texts are what foamDictionary of OpenFOAM v1912 prints for the same input.

TEST(DictionaryPrint, writesOpenFoamsForm)
{
    Dictionary const dictionary = Dictionary::fromText(R"(
FoamFile { version 2.0; class dictionary; }
deltaT 0.00100; big 123456789.123; i 42; longKeywordThatIsLonger 3; s "a \"quoted\" str";
"(U|k).*" { tolerance 1e-5; sub { } }
empty; w a,b div(phi,U) x=y;
)");
    EXPECT_EQ(dictionary.str(), R"(FoamFile
{
    version         2;
    class           dictionary;
}

deltaT          0.001;

big             1.23457e+08;

i               42;

longKeywordThatIsLonger 3;

s               "a \"quoted\" str";

"(U|k).*"
{
    tolerance       1e-05;
    sub
    {
    }
}

empty           ;

w               a,b div(phi,U) x=y;
)");
}

std::string printed(std::string const& value) { return Dictionary::fromText("k 5; d { x 1; } a " + value + ";").entryText("a"); }

TEST(DictionaryPrint, separatesTokensBySingleBlanks)
{
    EXPECT_EQ(printed("((1  2 3)(4 5 6))"), "( ( 1 2 3 ) ( 4 5 6 ) )");
    EXPECT_EQ(printed("3{0}"), "3 { 0 }");
    EXPECT_EQ(printed("()"), "( )");
    EXPECT_EQ(printed("[0 2 -1 0 0 0 0] 1e-6"), "[ 0 2 -1 0 0 0 0 ] 1e-06");
    EXPECT_EQ(printed("a/b -$k"), "a / b - 5");
    EXPECT_EQ(printed("(box { x 1; } )"), "( box { x 1 ; } )");
    EXPECT_EQ(printed("$d"), "x 1 ;");
    EXPECT_EQ(printed("2147483648 2147483647 -0.0 100000.5"), "2.14748e+09 2147483647 0 100000");
}

TEST(DictionaryPrint, writesResultsOfEvalWithAllTheirDigits)
{
    EXPECT_EQ(printed("#eval{ 1/3 }"), "0.3333333333333333");
    EXPECT_EQ(printed("#eval{ 1/4 } (#eval{ 2*3 } 0)"), "0.25 ( 6 0 )");
    Dictionary const dictionary = Dictionary::fromText("a #eval{ sqrt(2)*1e-7 }; b $a; c #eval{ $b };");
    for (std::string const key : {"a", "b", "c"})
        EXPECT_EQ(std::stod(dictionary.entryText(key)), std::sqrt(2.0) * 1e-7) << dictionary.entryText(key);
}

TEST(DictionaryPrint, writesTypedListsAsLists)
{
    EXPECT_EQ(printed("nonuniform List<scalar> 3(1 2 3)"), "nonuniform List<scalar> 3(1 2 3)");
    EXPECT_EQ(printed("List<label> 2(3 3)"), "List<label> 2{3}");
    EXPECT_EQ(printed("List<scalar> ()"), "List<scalar> 0()");
    EXPECT_EQ(printed("List<vector> 2((1 2 3)(4 5 6))"), "List<vector> 2((1 2 3) (4 5 6))");
    EXPECT_EQ(printed("List<bool> 2(true false)"), "List<bool> 2(1 0)");
    EXPECT_EQ(printed("List<scalar> 11(1 2 3 4 5 6 7 8 9 10 11)"), "List<scalar> \n11\n(\n1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n)\n");
}

TEST(DictionaryPrint, printsScopedEntriesStatementsAndKeywords)
{
    Dictionary const dictionary = Dictionary::fromText("a { b { c 1; \"x.*\" 2; } } x.y 3;");
    EXPECT_EQ(dictionary.entryText("a/b/c"), "1");
    EXPECT_EQ(dictionary.entryText("a.b.c"), "1");
    EXPECT_EQ(dictionary.entryText("x.y"), "3");
    EXPECT_EQ(dictionary.entryText("a.b"), "{\n    c               1;\n    \"x.*\"           2;\n}");
    EXPECT_EQ(dictionary.entryStatement("a.b.c"), "c               1;\n");
    EXPECT_EQ(dictionary.entryKeywords(), (std::vector<std::string>{"a", "x.y"}));
    EXPECT_EQ(dictionary.entryKeywords("a.b"), (std::vector<std::string>{"c", "\"x.*\""}));
    EXPECT_THROW(static_cast<void>(dictionary.entryText("a.c")), mpsDem::CaseError);
    auto const wedge = Dictionary::fromText("wedge { topX 1; lowX 2; }");
    for (std::string const entry : {"wedge/topXX", "wedge.topXX"}) try
        {
            static_cast<void>(wedge.entryText(entry));
            ADD_FAILURE() << entry << " was found";
        }
        catch (mpsDem::CaseError const& error)
        {
            EXPECT_NE(std::string(error.what()).find("did you mean topX?"), std::string::npos) << error.what();
        }
}

TEST(DictionaryPrint, printedTextReadsBackToTheSameText)
{
    Dictionary const dictionary = Dictionary::fromText("a { b (1 2); } s \"x\\\"y\"; l List<scalar> 12{0.5}; v #{ a; #}; \"p.*\" 1;");
    EXPECT_EQ(Dictionary::fromText(dictionary.str()).str(), dictionary.str());
}

} // namespace
