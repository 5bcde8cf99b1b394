#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/CommandLine.h"
#include "common/CommandLineError.h"
#include "core/Errors.h"

namespace {

using namespace mpsDem;

ApplicationDescription description(std::string const& arguments = "")
{
    return {"anyApp", "Does something.", {{"dict", "file", "another dictionary"}, {"overwrite", "", "replaces"}}, arguments, false, true};
}

CommandLine parse(std::vector<char const*> words, std::string const& arguments = "")
{
    words.insert(words.begin(), "anyApp");
    return CommandLine(description(arguments), static_cast<int>(words.size()), words.data());
}

std::string refusal(std::vector<char const*> const& words, std::string const& arguments = "")
{
    try
    {
        static_cast<void>(parse(words, arguments));
    }
    catch (CommandLineError const& error)
    {
        return error.what();
    }
    return "accepted";
}

int run(std::vector<char const*> words, std::function<int(CommandLine const&)> const& work)
{
    words.insert(words.begin(), "anyApp");
    return runApplication(description(), static_cast<int>(words.size()), words.data(), work);
}

TEST(SetParticlesCommandLine, OptionsAreWrittenWithOneDash)
{
    CommandLine const line = parse({"-case", "some dir", "-overwrite"});
    EXPECT_EQ(line.caseRoot(), "some dir");
    EXPECT_TRUE(line.found("overwrite"));
    EXPECT_FALSE(line.found("dict"));
    EXPECT_EQ(line.valueOr("dict", "system/d"), "system/d");
    EXPECT_EQ(parse({}).caseRoot(), ".");
    EXPECT_EQ(line.command(), "anyApp -case some dir -overwrite");
}

TEST(SetParticlesCommandLine, WrongOptionsAreNamed)
{
    EXPECT_EQ(refusal({"-foo"}), "Invalid option: -foo");
    EXPECT_EQ(refusal({"--foo"}), "Invalid option: -foo");
    EXPECT_EQ(refusal({"-over"}), "Invalid option: -over");
    EXPECT_NE(refusal({"-case"}).find("-case"), std::string::npos);
    EXPECT_NE(refusal({"-case", "-overwrite"}).find("-case"), std::string::npos);
    EXPECT_EQ(refusal({"-overwrite", "-overwrite"}), "Option -overwrite is given twice");
    EXPECT_EQ(refusal({"file"}), "Unexpected argument: file");
    EXPECT_EQ(refusal({"file"}, "<file>"), "accepted");
    EXPECT_EQ(parse({"a", "-case", "b", "c"}, "<file>").arguments(), (std::vector<std::string>{"a", "c"}));
}

TEST(SetParticlesCommandLine, HelpNamesEveryOption)
{
    std::string const help = parse({"-help"}).help();
    for (char const* text : {"Usage: anyApp [OPTIONS]", "  -case <dir>", "  -dict <file>", "  -overwrite", "  -help"})
        EXPECT_NE(help.find(text), std::string::npos) << text;
    EXPECT_EQ(help.find("--"), std::string::npos);
}

TEST(SetParticlesCommandLine, ErrorsBecomeExitCodesAndOpenFoamsWords)
{
    testing::internal::CaptureStderr();
    EXPECT_EQ(run({}, [](CommandLine const&) { return 0; }), 0);
    EXPECT_EQ(run({"-foo"}, [](CommandLine const&) { return 0; }), 2);
    EXPECT_EQ(run({},
                  [](CommandLine const&) -> int {
                      throw CaseError(ExitCode::BadInput, Location{"system/controlDict", 12, "endTime"}, "endTime is missing", "a time");
                  }),
              2);
    EXPECT_EQ(run({}, [](CommandLine const&) -> int { throw CaseError(ExitCode::Locked, "the case is in use"); }), 4);
    EXPECT_EQ(run({}, [](CommandLine const&) -> int { throw std::bad_alloc(); }), 8);
    EXPECT_EQ(run({}, [](CommandLine const&) -> int { throw std::logic_error("oops"); }), 9);
    std::string const text = testing::internal::GetCapturedStderr();
    EXPECT_NE(text.find("Invalid option: -foo\nSee 'anyApp -help' for usage\n"), std::string::npos);
    EXPECT_NE(text.find("--> FOAM FATAL IO ERROR: \nendTime is missing\n    a time\n\nfile: system/controlDict.endTime at line 12.\n"),
              std::string::npos);
    EXPECT_NE(text.find("--> FOAM FATAL ERROR: \nthe case is in use\n"), std::string::npos);
}

TEST(SetParticlesCommandLine, BannerHasOpenFoamsLines)
{
    std::string const text = banner(parse({"-case", "/tmp"}));
    for (char const* word : {"Build  : ", "Arch   : ", "Exec   : anyApp -case /tmp",
                             "Date   : ", "Time   : ", "Host   : ", "PID    : ", "I/O    : uncollated", "Case   : /tmp\n", "nProcs : 1"})
        EXPECT_NE(text.find(word), std::string::npos) << word;
}

} // namespace
