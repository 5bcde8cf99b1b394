#include <cmath>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

#include "core/Log.h"
#include "postGauges/ConvergencePlot.h"
#include "postGauges/Curve.h"
#include "postGauges/TableSource.h"
#include "support/TemporaryFolder.h"

namespace mpsDem::postGauges {

namespace {

namespace fs = std::filesystem;

void put(fs::path const& path, std::string const& text)
{
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

TableSource source(std::string const& text) { return TableSource::read(Dictionary::fromText(text)); }

std::string messageOf(std::function<void()> const& action)
{
    try
    {
        action();
    }
    catch (CaseError const& error)
    {
        return error.what();
    }
    return {};
}

/// A case whose gauges were written from 0, repeated from 0, and restarted at 0.5.
void makeCase(fs::path const& root)
{
    fs::path const gauges = root / "postProcessing" / "gauges";
    put(gauges / "0" / "eta.dat", "# Time eta0\n0 9\n1 9\n");
    put(gauges / "0" / "eta_0.dat", "# Time eta0[m]\n0 1\n0.25 2\n0.5 3\n0.75 4\n");
    put(gauges / "0.5" / "eta.dat", "# Time eta0[m]\n0.5 30\n0.75 40\n");
}

} // namespace

TEST(PostGaugesTableSource, laterStartsReplaceWhatEarlierOnesWrote)
{
    TemporaryFolder const folder;
    makeCase(folder.path());
    PostCase postCase;
    postCase.root = folder.path();
    Table const joined = source("object gauges; file eta.dat;").load(postCase);
    EXPECT_EQ(columnOf(joined, "Time", {}), (std::vector<Real>{0, 0.25, 0.5, 0.75}));
    EXPECT_EQ(columnOf(joined, "eta0", {}), (std::vector<Real>{1, 2, 30, 40})) << "the name without its unit";
    EXPECT_EQ(columnOf(joined, "2", {}).back(), 40) << "by number";
    EXPECT_EQ(source("object gauges; startTime latest;").load(postCase).rows(), 2U) << "the only table of the object";
    EXPECT_EQ(source("object gauges; startTime 0;").load(postCase).rows(), 4U) << "the newest of repeated runs";
}

TEST(PostGaugesTableSource, messagesNameWhatExists)
{
    TemporaryFolder const folder;
    makeCase(folder.path());
    PostCase postCase;
    postCase.root = folder.path();
    EXPECT_NE(messageOf([&] { (void)source("object gauge;").load(postCase); }).find("did you mean gauges"), std::string::npos);
    EXPECT_NE(messageOf([&] { (void)source("object gauges; startTime 2;").load(postCase); }).find("start times: 0, 0.5"),
              std::string::npos);
    EXPECT_NE(messageOf([&] { (void)source("file \"postProcessing/eta.csv\";").load(postCase); }).find("no file"), std::string::npos);
    Table const table = source("object gauges; startTime latest;").load(postCase);
    EXPECT_NE(messageOf([&] { (void)columnOf(table, "eta1", {}); }).find("known columns: Time, eta0[m]"), std::string::npos);
}

TEST(PostGaugesTableSource, aTableOutsideIsFoundInTheCaseAndBesideTheTutorials)
{
    TemporaryFolder const folder;
    fs::path const root = folder.path() / "a" / "b" / "case";
    put(root / "postProcessing" / "x.dat", "# t x\n0 1\n");
    EXPECT_EQ(findTable(root, "postProcessing/x.dat"), root / "postProcessing/x.dat");
    char const* const shipped = "../../resources/wedgeEnvelope.dat";
    EXPECT_TRUE(fs::is_regular_file(findTable(root, shipped))) << "a copied case takes the tutorials' table";
    EXPECT_EQ(findTable(root, "../../resources/none.dat"), root / "../../resources/none.dat");
    put(folder.path() / "a" / "resources" / "wedgeEnvelope.dat", "# t x\n0 2\n");
    EXPECT_TRUE(fs::equivalent(findTable(root, shipped), folder.path() / "a" / "resources" / "wedgeEnvelope.dat"))
        << "one beside the case first";
    put(root / "resources" / "wedgeEnvelope.dat", "# t x\n0 3\n");
    EXPECT_EQ(findTable(root, shipped), root / "resources" / "wedgeEnvelope.dat") << "one in the case before all";
}

TEST(PostGaugesTableSource, aReferenceThatIsNotThereIsLeftOut)
{
    TemporaryFolder const folder;
    makeCase(folder.path());
    PostCase postCase;
    postCase.root = folder.path();
    auto const sources = [](std::string const& curves) {
        return readCurveSources(Dictionary::fromText("curves { " + curves + " }"), "curves");
    };
    muteLog(true);
    auto const curves = loadCurves(sources("mpsDem { object gauges; } book { file \"../../book/table.dat\"; }"), postCase);
    muteLog(false);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0].name, "mpsDem");
    EXPECT_THROW((void)loadCurves(sources("own { file \"postProcessing/own.dat\"; }"), postCase), CaseError) << "what the run should make";
    EXPECT_THROW((void)loadCurves(sources("own { object forces; }"), postCase), CaseError);
}

TEST(PostGaugesTableSource, tablesWithOtherColumnsAreNotJoined)
{
    Table const a{"a.dat", {"Time", "x"}, {{0}, {1}}};
    Table const b{"b.dat", {"Time", "y"}, {{0}, {1}}};
    EXPECT_THROW((void)joinTables({a, b}), CaseError);
    EXPECT_EQ(joinTables({a}).rows(), 1U);
}

TEST(PostGaugesTableSource, studyOfAccuracyAndCost)
{
    TemporaryFolder const folder;
    put(folder / "study.dat", "# a study\n# scheme seconds spacing error spread failed\npaper 12 0.04 0.2 0.03 0\nnoShift 60 0.02 - - 1\n");
    auto const runs = readStudy(folder / "study.dat");
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].scheme, "paper");
    EXPECT_EQ(runs[0].seconds, 12);
    EXPECT_EQ(runs[0].error, 0.2);
    EXPECT_TRUE(runs[1].failed);
    EXPECT_TRUE(std::isnan(runs[1].error));
    put(folder / "bad.csv", "scheme,spacing,error,spread,seconds,failed\npaper,0.04,none,0,12,0\n");
    EXPECT_NE(messageOf([&] { (void)readStudy(folder / "bad.csv"); }).find("bad.csv:2: error: \"none\""), std::string::npos);
    put(folder / "short.dat", "paper 0.04 0.2\n");
    EXPECT_NE(messageOf([&] { (void)readStudy(folder / "short.dat"); }).find("3 words, not 6"), std::string::npos);
}

} // namespace mpsDem::postGauges
