#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "core/Dictionary.h"

namespace {

namespace fs = std::filesystem;
using mpsDem::CaseError;
using mpsDem::Dictionary;
using mpsDem::ExitCode;

/// A case folder of its own for each test.
class DictionaryDirective : public testing::Test
{
protected:
    void SetUp() override
    {
        char const* const name = testing::UnitTest::GetInstance()->current_test_info()->name();
        root_ = fs::temp_directory_path() / ("dictionary" + std::to_string(getpid()) + name);
        fs::create_directories(root_ / "system");
    }
    void TearDown() override { fs::remove_all(root_); }

    void write(std::string const& file, std::string const& text) const
    {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }
    [[nodiscard]] Dictionary read(std::string const& text) const
    {
        write("system/main", text);
        return Dictionary::fromFile(root_ / "system/main", root_);
    }
    [[nodiscard]] std::string refusal(std::string const& text) const
    {
        try
        {
            static_cast<void>(read(text));
        }
        catch (CaseError const& error)
        {
            return error.what();
        }
        return "accepted";
    }

    fs::path root_;
};

TEST_F(DictionaryDirective, aFileNamedWithoutItsFolderIncludesAsAnyOther)
{
    write("main", "#includeIfPresent \"nope\"\n#include \"more\"\n");
    write("more", "a 1;");
    fs::path const before = fs::current_path();
    fs::current_path(root_);
    EXPECT_EQ(Dictionary::fromFile("main", root_).get<int>("a"), 1);
    EXPECT_EQ(Dictionary::fromFile("main", ".").get<int>("a"), 1);
    fs::current_path(before);
}

TEST_F(DictionaryDirective, includeReadsAFileBesideTheOneThatNamesIt)
{
    write("system/common", "H 0.8;\n#include \"deeper/more\"\n");
    write("system/deeper/more", "L 2;\n");
    Dictionary const dictionary = read("#include \"common\"\nhalf #eval{ $H/2 };\nsub { #include \"common\" }\n");
    EXPECT_EQ(dictionary.get<double>("half"), 0.4);
    EXPECT_EQ(dictionary.get<int>("L"), 2);
    EXPECT_EQ(dictionary.subDict("sub").get<int>("L"), 2);
    EXPECT_EQ(dictionary.where("L").file, "system/deeper/more");
    EXPECT_EQ(dictionary.where("half").str(), "system/main:2");
}

TEST_F(DictionaryDirective, includeKnowsTheCaseAndMacrosInItsName)
{
    write("constant/setup", "H 0.8;\n");
    EXPECT_TRUE(read("#include \"$FOAM_CASE/constant/setup\"\n").found("H"));
    EXPECT_TRUE(read("#include \"<case>/constant/setup\"\n").found("H"));
    EXPECT_TRUE(read("#include \"<constant>/setup\"\n").found("H"));
    EXPECT_TRUE(read("name setup;\n#include \"../constant/${name}\"\n").found("H"));
    EXPECT_EQ(read("a (1 #include \"<constant>/setup\" 2);").entryText("a"), "( 1 H 0.8 2 )");
}

TEST_F(DictionaryDirective, optionalIncludesMayBeAbsent)
{
    EXPECT_EQ(read("#includeIfPresent \"nope\"\n#sinclude \"nope\"\na 1;").keys(), std::vector<std::string>{"a"});
    EXPECT_NE(refusal("#include \"nope\"\n").find("system/main:1: the include \"nope\" is not there"), std::string::npos);
}

TEST_F(DictionaryDirective, entriesOfAnIncludeAreDefaults)
{
    write("system/common", "H 0.8;\nsub { x 1; }\n");
    Dictionary const dictionary = read("#include \"common\"\nH 1.2;\nsub { x 2; }\n");
    EXPECT_EQ(dictionary.get<double>("H"), 1.2);
    EXPECT_EQ(dictionary.subDict("sub").get<int>("x"), 2);
    EXPECT_NE(refusal("H 1.2;\n#include \"common\"\n").find("is there already (system/main:1)"), std::string::npos);
}

TEST_F(DictionaryDirective, includeEtcReadsTheInstallationsDicts)
{
    write("etc/caseDicts/probes", "type probes;\n");
    write("etc/secret", "a 1;\n");
    fs::create_directories(root_ / "other");
    setenv("MPSDEM_ETC", (root_ / "etc").c_str(), 1);
    write("other/main", "#includeEtc \"caseDicts/probes\"\n#sincludeEtc \"caseDicts/nope\"\n");
    EXPECT_EQ(Dictionary::fromFile(root_ / "other/main", root_ / "other").get<std::string>("type"), "probes");
    write("other/main", "#includeEtc \"secret\"\n");
    EXPECT_THROW(Dictionary::fromFile(root_ / "other/main", root_ / "other"), CaseError);
    unsetenv("MPSDEM_ETC");
}

TEST_F(DictionaryDirective, includeCannotLeaveTheCaseThroughALink)
{
    fs::create_symlink("/etc/passwd", root_ / "system/link");
    EXPECT_NE(refusal("#include \"link\"\n").find("leaves the case"), std::string::npos);
    EXPECT_NE(refusal("#sinclude \"link\"\n").find("leaves the case"), std::string::npos);
}

TEST_F(DictionaryDirective, absentFilesAreBadInputAndFoldersAreRefused)
{
    try
    {
        static_cast<void>(Dictionary::fromFile(root_ / "system/absent", root_));
        FAIL();
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        EXPECT_STREQ(error.what(), "system/absent: the file is not there");
    }
    EXPECT_THROW(Dictionary::fromFile(root_ / "system", root_), CaseError);
}

TEST_F(DictionaryDirective, inputModeSaysWhatADuplicateMeans)
{
    EXPECT_EQ(read("#inputMode merge\na 1; a 2;").get<int>("a"), 2);
    EXPECT_EQ(read("#inputMode overwrite\na { x 1; } a { y 2; }").subDict("a").keys(), std::vector<std::string>{"y"});
    EXPECT_EQ(read("#inputMode protect\na 1; a 2;").get<int>("a"), 1);
    EXPECT_EQ(read("#inputMode warn\na 1; a 2;").get<int>("a"), 1);
    EXPECT_EQ(read("#inputMode overwrite\na 1; b 2; a 3;").keys(), (std::vector<std::string>{"a", "b"}));
    EXPECT_NE(refusal("#inputMode merge\na 1; #inputMode default\na 2;").find("is there already"), std::string::npos);
}

TEST_F(DictionaryDirective, removeTakesWordsPatternsAndLists)
{
    EXPECT_EQ(read("a 1; b 2; #remove a\nc 3;").keys(), (std::vector<std::string>{"b", "c"}));
    EXPECT_EQ(read("ab 1; abc 2; c 3; #remove \"ab.*\"\n").keys(), std::vector<std::string>{"c"});
    EXPECT_EQ(read("ab 1; abc 2; c 3; d 4; #remove (\"ab.*\" d nothing)\n").keys(), std::vector<std::string>{"c"});
}

TEST_F(DictionaryDirective, conditionsChooseABranch)
{
    EXPECT_EQ(read("v 1;\n#ifeq $v 1\nx yes;\n#else\nx no;\n#endif\n").get<std::string>("x"), "yes");
    EXPECT_EQ(read("v abc;\n#ifeq \"$v\" def\nx yes;\n#else\nx no;\n#endif\n").get<std::string>("x"), "no");
    EXPECT_EQ(read("#ifeq (1 2) (1 2.0)\nx yes;\n#endif\n").get<std::string>("x"), "yes");
    EXPECT_EQ(read("#if off\nx 1; } \n#if on\n#else\n#endif\n#else\nx 2;\n#endif\n").get<int>("x"), 2);
    EXPECT_EQ(read("n 3;\n#if #eval{ $n > 2 }\nx 1;\n#else\nx 2;\n#endif\n").get<int>("x"), 1);
}

} // namespace
