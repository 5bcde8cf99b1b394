#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "core/Dictionary.h"

namespace {

using mpsDem::CaseError;
using mpsDem::Dictionary;
using mpsDem::Real;

/// The message that `action` is refused with.
template <class Action>
std::string refusal(Action const& action)
{
    try
    {
        action();
    }
    catch (CaseError const& error)
    {
        return error.what();
    }
    return "accepted";
}

TEST(DictionaryStrict, refusesAnEntryThatNobodyAskedForAndNamesTheNearest)
{
    Dictionary const dictionary = Dictionary::fromText("deltaT 1;\nwriteIntervall 2;\n", "system/controlDict");
    static_cast<void>(dictionary.get<Real>("deltaT"));
    static_cast<void>(dictionary.getOr<Real>("writeInterval", 1));
    EXPECT_EQ(refusal([&] { dictionary.requireAllRead(); }), "system/controlDict:2: the entry \"writeIntervall\" is not known here\n"
                                                             "    known entries: deltaT, writeInterval   (did you mean writeInterval?)");
}

TEST(DictionaryStrict, looksIntoDictionariesListsAndPatterns)
{
    Dictionary const dictionary = Dictionary::fromText(R"(a { x 1; } "p.*" { tol 1; } regions ( box { y 1; z 2; } ); off { anything 1; })");
    static_cast<void>(dictionary.subDict("a").get<int>("x"));
    static_cast<void>(dictionary.subDict("pFinal").get<int>("tol"));
    auto const regions = dictionary.getDictList("regions");
    static_cast<void>(regions[0].second.get<int>("y"));
    dictionary.ignore("off");
    EXPECT_NE(refusal([&] { dictionary.requireAllRead(); }).find("\"z\" is not known"), std::string::npos);
    static_cast<void>(dictionary.getDictList("regions")[0].second.found("z"));
    dictionary.requireAllRead();
}

TEST(DictionaryStrict, anAbsentDictionaryStillTakesQuestions)
{
    Dictionary const dictionary = Dictionary::fromText("a 1;", "f");
    Dictionary const shifting = dictionary.subDictOrEmpty("shifting");
    EXPECT_EQ(shifting.getOr<Real>("coefficient", 0.5), 0.5);
    EXPECT_EQ(shifting.name(), "shifting");
    EXPECT_EQ(refusal([&] { static_cast<void>(shifting.get<Real>("coefficient")); }), "f:1: the entry \"coefficient\" is missing\n"
                                                                                      "    coefficient <number>;");
}

TEST(DictionaryStrict, hintsAtAMissingSemicolon)
{
    Dictionary const dictionary = Dictionary::fromText("deltaT 0.001\nwriteControl adjustable;\n", "system/controlDict");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<Real>("deltaT")); }),
              "system/controlDict:1: deltaT has more than one value: 0.001 writeControl adjustable\n"
              "    is a ';' missing at the end of line 1?");
}

TEST(DictionaryStrict, pointsAtTheEntryThatIsAMisspeltMissingOne)
{
    Dictionary const dictionary = Dictionary::fromText("a 1;\ndelatT 1;\nsolver { }\nmasss 2;", "f");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<Real>("deltaT")); }),
              "f:2: \"delatT\" looks like a misspelling: the entry \"deltaT\" is missing\n    did you mean deltaT?");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.subDict("solvers")); }),
              "f:3: \"solver\" looks like a misspelling: the dictionary \"solvers\" is missing\n    did you mean solvers?");
    EXPECT_EQ(refusal([&] {
                  dictionary.refuseMisspelt({"mass", "density"});
              }),
              "f:4: \"masss\" looks like a misspelling: the entry \"mass\" is missing\n    did you mean mass?");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.subDict("a")); }), "f:1: a must be a dictionary\n    a { ... }");
}

TEST(DictionaryStrict, takesNoEntryForAMisspellingThatIsKnownOrFar)
{
    Dictionary const dictionary = Dictionary::fromText("lower 1;\nyScale 2;", "f");
    EXPECT_EQ(dictionary.get<Real>("yScale"), 2);
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<Real>("upper")); }),
              "f:1: the entry \"upper\" is missing\n    upper <number>;");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<Real>("xScale")); }),
              "f:1: the entry \"xScale\" is missing\n    xScale <number>;");
    dictionary.refuseMisspelt({"upper", "xScale"});
}

TEST(DictionaryStrict, saysWhatAMissingEntryMayBe)
{
    Dictionary const dictionary = Dictionary::fromText("other 1;", "f");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.getInRange("mu", 0, 2)); }),
              "f:1: the entry \"mu\" is missing\n    mu <number>;   in [0, 2]");
    EXPECT_EQ(refusal([&] {
                  static_cast<void>(dictionary.getDimensioned("rho", {1, -3, 0, 0, 0, 0, 0}));
              }),
              "f:1: the entry \"rho\" is missing\n    rho <number>;   dimensions may stand before it: [1 -3 0 0 0 0 0]");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<mpsDem::Vector>("U")); }), "f:1: the entry \"U\" is missing\n    U (x y z);");
    EXPECT_EQ(refusal([&] {
                  static_cast<void>(dictionary.getWord("law", {"linear", "hertz"}, "laws"));
              }),
              "f:1: the entry \"law\" is missing\n    law <word>;   known laws: linear, hertz");
}

TEST(DictionaryStrict, saysThatAPlainNumberTakesNoDimensions)
{
    Dictionary const dictionary =
        Dictionary::fromText("spacing [0 1 0 0 0 0 0] 0.02;\nE E [1 -1 -2 0 0 0 0] 1e6;\ng (0 -9.81);\nh (0 1 2 3);", "f");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<Real>("spacing")); }),
              "f:1: spacing takes no dimensions: it is a plain number in SI units\n    spacing <number>;");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.getInRange("E", 0, 1e9)); }),
              "f:2: E takes no dimensions: it is a plain number in SI units\n    E <number>;");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<mpsDem::Vector>("g")); }),
              "f:3: g: a vector (x y z) has 3 numbers, not 2\n    in 2-D too: z is 0");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.get<mpsDem::Vector>("h")); }), "f:4: h: a vector (x y z) has 3 numbers, not more");
}

TEST(DictionaryStrict, findsWordsThatBeginAlikeOrDifferInCapitals)
{
    std::vector<std::string> const laws = {"hertzMindlin", "linearSpringDashpot"};
    EXPECT_EQ(mpsDem::nearestWord("linearSpring", laws), "linearSpringDashpot");
    EXPECT_EQ(mpsDem::nearestWord("HERTZMINDLIN", laws), "hertzMindlin");
    EXPECT_EQ(mpsDem::nearestWord("sticky", laws), "");
    EXPECT_EQ(mpsDem::nearestWord("", std::vector<std::string>{"x"}), "");
    EXPECT_EQ(mpsDem::shortNumber(-0.02), "-0.02");
    EXPECT_EQ(mpsDem::shortNumber(1e-6), "1e-06");
}

TEST(DictionaryStrict, checksRangesAndWords)
{
    Dictionary const dictionary = Dictionary::fromText("mu -0.1; type slidee; law;", "f");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.getInRange("mu", 0, 2)); }), "f:1: mu is -0.1\n    allowed: in [0, 2]");
    EXPECT_EQ(refusal([&] { static_cast<void>(dictionary.getInRange("mu", 0, 1e300)); }), "f:1: mu is -0.1\n    allowed: at least 0");
    EXPECT_EQ(dictionary.getInRangeOr("e", 0.5, 0, 1), 0.5);
    EXPECT_EQ(dictionary.getWordOr("shape", "flat", {"flat", "round"}, "shapes"), "flat");
    EXPECT_EQ(refusal([&] {
                  static_cast<void>(dictionary.getWordOr("law", "linear", {"linear", "Hertz"}, "laws"));
              }),
              "f:1: law has no value\n    known laws: linear, Hertz");
    EXPECT_EQ(refusal([&] {
                  static_cast<void>(dictionary.getWord("type", {"slide", "wedge"}, "types"));
              }),
              "f:1: type \"slidee\" is not known\n    known types: slide, wedge   (did you mean slide?)");
}

TEST(DictionaryStrict, theLenientReaderShowsWhatWouldRunCodeWithAWarning)
{
    auto const file = std::filesystem::temp_directory_path() / ("code" + std::to_string(getpid()));
    std::ofstream(file) << "functions\n{\n    a { type coded; }\n    b { type systemCall; }\n}\nc { libs (x); }\n";
    std::vector<std::string> warnings;
    Dictionary const dictionary = Dictionary::fromFileLeniently(file, file.parent_path(), warnings);
    EXPECT_EQ(dictionary.entryText("functions.a.type"), "coded");
    ASSERT_EQ(warnings.size(), 3U);
    EXPECT_NE(warnings[0].find(":3: type coded is shown as data"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[1].find(":4: type systemCall is shown as data"), std::string::npos) << warnings[1];
    EXPECT_NE(warnings[2].find(":6: libs is shown as data"), std::string::npos) << warnings[2];
    EXPECT_THROW(Dictionary::fromFile(file, file.parent_path()), mpsDem::CaseError);
    std::ofstream(file) << "a #calc \"1\";\n"; // what would have to be run to be shown stays an error
    EXPECT_THROW(Dictionary::fromFileLeniently(file, file.parent_path(), warnings), mpsDem::CaseError);
    std::filesystem::remove(file);
}

TEST(DictionaryStrict, theLenientReaderTakesTheLastDuplicateWithAWarning)
{
    auto const file = std::filesystem::temp_directory_path() / ("lenient" + std::to_string(getpid()));
    std::ofstream(file) << "a 1;\na 2;\nlibs (fast);\nb 0x10;\n";
    std::vector<std::string> warnings;
    Dictionary const dictionary = Dictionary::fromFileLeniently(file, file.parent_path(), warnings);
    std::filesystem::remove(file);
    EXPECT_EQ(dictionary.get<int>("a"), 2);
    EXPECT_EQ(dictionary.entryText("b"), "0 x10");
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings[0].find(":2: the entry \"a\" is there already"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[1].find(":3: libs is shown as data; in a case it is refused"), std::string::npos) << warnings[1];
}

TEST(DictionaryStrict, requiresTheHeader)
{
    std::string const header = "FoamFile { version 2.0; format ascii; class dictionary; object g; }\n";
    Dictionary const good = Dictionary::fromText(header + "a 1;");
    good.requireHeader();
    EXPECT_EQ(good.keys(), std::vector<std::string>{"a"});
    static_cast<void>(good.found("a"));
    good.requireAllRead();
    EXPECT_NE(refusal([] { Dictionary::fromText("a 1;").requireHeader(); }).find("the header FoamFile is missing"), std::string::npos);
    EXPECT_NE(refusal([&] { Dictionary::fromText("a 1;" + header).requireHeader(); }).find("at the top"), std::string::npos);
    EXPECT_NE(refusal([&] { good.requireHeader("volScalarField"); }).find("class is dictionary"), std::string::npos);
}

} // namespace
