#include <limits>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "core/Log.h"
#include "postGauges/MapPlot.h"
#include "postGauges/Plot.h"
#include "postGauges/SheetLayout.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace {

std::string messageOf(std::string const& plots)
{
    try
    {
        (void)readPlots(Dictionary::fromText("plots { " + plots + " }", "system/postGaugesDict"), {});
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput);
        return error.what();
    }
    return {};
}

void expectMessage(std::string const& plots, std::string const& part)
{
    EXPECT_NE(messageOf(plots).find(part), std::string::npos) << messageOf(plots);
}

} // namespace

TEST(PostGaugesPlot, readsEveryKind)
{
    auto const dict =
        Dictionary::fromText("plots { a { type curves; curves { c { file \"t.csv\"; } } } b { type gauges; locations ((4 0 0)); }"
                             " c { type profiles; times (0.5); } d { type particles; } e { type convergence; file \"s.dat\"; }"
                             " f { type particles; view space; } g { type waterSurface; } h { type map; object waves; } }");
    auto const plots = readPlots(dict, {});
    ASSERT_EQ(plots.size(), 8U);
    EXPECT_EQ(plots[3]->name(), "d");
}

TEST(PostGaugesPlot, readsTheSpecimen)
{
    std::filesystem::path const folder = std::filesystem::path(MPSDEM_TEST_DATA).parent_path() / "etc" / "caseDicts";
    auto const dict = Dictionary::fromFile(folder / "postGaugesDict", folder);
    dict.requireHeader();
    PostCase const postCase = PostCase::read(folder, {}, dict);
    EXPECT_EQ(postCase.spacing, 0.02);
    EXPECT_EQ(readPlots(dict, postCase.pictures).size(), 8U);
}

TEST(PostGaugesPlot, refusesWhatItDoesNotKnow)
{
    expectMessage("a { type curve; }", "did you mean curves");
    expectMessage("a { type gauges; locations ((4 0 0)); metod top; }", "did you mean method");
    expectMessage("a { type gauges; locations ((4 0 0)); method volum; }", "did you mean volume");
    expectMessage("a { type gauges; locations (); }", "no location");
    expectMessage("a { type gauges; locations ((4 0 0)); width 0.5; }", "width is 0.5");
    expectMessage("a { type particles; window ((1 0 0) (0 1 0)); }", "window must be two corners");
    expectMessage("a { type particles; palette jet; }", "palette \"jet\" is not known");
    expectMessage("a { type particles; show (fluids); }", "did you mean fluid");
    expectMessage("a { type particles; view spaced; }", "did you mean space");
    expectMessage("a { type particles; camera { azimuth 20; } }", "camera");
    expectMessage("a { type waterSurface; camera { elevation 91; } }", "elevation is 91");
    expectMessage("a { type waterSurface; region ((1 0 0) (0 1 1)); }", "region must be two corners");
    expectMessage("a { type waterSurface; clip { point (0 0 0); normal (0 0 0); } }", "normal of the clip plane");
    expectMessage("a { type waterSurface; opacity 0; }", "opacity is 0");
    expectMessage("a { type curves; }", "no curves");
    expectMessage("a { type curves; curves { c { file x; colour pink; } } }", "colour \"pink\"");
    expectMessage("a { type curves; xRange (2 1); curves { c { file x; } } }", "two increasing numbers");
    expectMessage("a { type curves; logScale (y); yRange (0 1); curves { c { file x; } } }", "above zero");
    expectMessage("a { type curves; formats (pdf); curves { c { file x; } } }", "format \"pdf\"");
    expectMessage("a { type curves; curves { c { file x; } d { file x; } } compare { reference e; } }", "known curves: c, d");
    expectMessage("\"../a\" { type particles; }", "cannot be the name of a picture file");
    expectMessage("", "plots is empty");
}

namespace {

/// Fails, or notes that it was drawn.
class StandInPlot : public Plot
{
public:
    StandInPlot(std::string const& name, std::vector<std::string>& drawn, std::optional<ExitCode> failure)
        : Plot(name),
          drawn_(drawn),
          failure_(failure)
    {}
    void draw(PostCase const&) const override
    {
        if (failure_) throw CaseError(*failure_, "no table for " + name());
        drawn_.push_back(name());
    }

private:
    std::vector<std::string>& drawn_;
    std::optional<ExitCode> failure_;
};

} // namespace

TEST(PostGaugesPlot, onePlotThatFailsDoesNotStopTheOthers)
{
    std::vector<std::string> drawn;
    std::vector<std::unique_ptr<Plot>> plots;
    plots.push_back(std::make_unique<StandInPlot>("front", drawn, ExitCode::InputOutput));
    plots.push_back(std::make_unique<StandInPlot>("energy", drawn, std::nullopt));
    plots.push_back(std::make_unique<StandInPlot>("waves", drawn, ExitCode::BadInput));
    muteLog(true);
    try
    {
        drawPlots(plots, {});
        ADD_FAILURE() << "accepted";
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::InputOutput);
        EXPECT_NE(std::string(error.what()).find("2 of 3 plots are not drawn: front, waves"), std::string::npos) << error.what();
    }
    EXPECT_EQ(drawn, std::vector<std::string>{"energy"});
    plots.erase(plots.begin(), plots.begin() + 2);
    try
    {
        drawPlots(plots, {});
        ADD_FAILURE() << "accepted";
    }
    catch (CaseError const& error)
    {
        EXPECT_EQ(error.code(), ExitCode::BadInput) << "a plot alone fails with its own message";
        EXPECT_STREQ(error.what(), "no table for waves");
    }
    muteLog(false);
}

TEST(PostGaugesText, namesCannotBecomeCommands)
{
    EXPECT_EQ(quoted("it's"), "'it''s'");
    EXPECT_EQ(quoted("a\n!rm -rf b\t"), "'a !rm -rf b '");
    EXPECT_EQ(plain("case_a {1}"), "case\\_a \\{1\\}");
    EXPECT_TRUE(isFileName("eta-4m_t0.5"));
    for (char const* const name : {"", ".hidden", "a/b", "a b", "a;b", "`a`"}) EXPECT_FALSE(isFileName(name)) << name;
}

TEST(PostGaugesText, numbers)
{
    EXPECT_EQ(decimalsThatDiffer({0.5, 0.75}, 2), 2);
    EXPECT_EQ(decimalsThatDiffer({0.5, 0.5004, 1}, 2), 4);
    EXPECT_EQ(decimalsThatDiffer({1, 1}, 2), 2);
    EXPECT_EQ(fixedNumber(0.5, 3), "0.500");
    std::string row;
    addRow(row, {0.1, std::numeric_limits<Real>::quiet_NaN()});
    EXPECT_EQ(row, "0.1 nan\n");
}

TEST(PostGaugesSheetLayout, panelsHaveTheProportionsOfTheWindow)
{
    Window const window{-0.3, 3, -0.1, 1.35};
    for (int const count : {1, 2, 4, 7})
    {
        SheetLayout const sheet = layOut(count, 0, window, 1200, 1600, 13, 110);
        ASSERT_EQ(sheet.panels.size(), static_cast<std::size_t>(count));
        EXPECT_LE(sheet.width, 1200);
        EXPECT_LE(sheet.height, 1600);
        for (Box const& panel : sheet.panels)
        {
            Real const wide = (panel.right - panel.left) * sheet.width, high = (panel.top - panel.bottom) * sheet.height;
            EXPECT_NEAR(wide / high, 3.3 / 1.45, 0.01);
            EXPECT_NEAR(wide, sheet.scale * 3.3, 1.0);
            EXPECT_LT(panel.right, sheet.bar.left);
            EXPECT_GE(panel.bottom, 0);
        }
    }
    SheetLayout const plain = layOut(6, 3, window, 1200, 1600, 13, 110), titled = layOut(6, 3, window, 1200, 1600, 13, 110, 34);
    EXPECT_EQ(titled.height, plain.height + 34) << "room for a title";
    EXPECT_GE((plain.panels[1].left - plain.panels[0].right) * plain.width, 50) << "room for half a number of either axis";
    EXPECT_LT(plain.bar.top, plain.panels.front().top) << "room for the words above the bar";
    EXPECT_EQ(layOut(6, 3, window, 1200, 1600, 13, 110).rows, 2);
    EXPECT_EQ(layOut(1, 0, {0, 1, 0, 100}, 1200, 800, 13, 110).height, 800) << "a tall window is limited by the height";
}

TEST(PostGaugesSheetLayout, rangesThatReadWell)
{
    EXPECT_EQ(niceRange(0, 9788), std::pair(0.0, 10000.0));
    EXPECT_EQ(niceRange(-0.31, 1.93), std::pair(-0.5, 2.0));
    auto const [low, high] = niceRange(5, 5);
    EXPECT_LT(low, 5);
    EXPECT_GT(high, 5);
    EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 0.5), 3);
    EXPECT_EQ(percentile({5, 1, 4, 2, 3}, 1), 5);
}

TEST(PostGaugesMap, TakesRowsOfPlaces)
{
    Table table;
    table.names = {"x", "y", "z", "etaMax"};
    table.columns = {{0, 1, 2, 0, 1, 2}, {0, 0, 0, 0, 0, 0}, {5, 5, 5, 6, 6, 6}, {1, 2, 3, 4, 5, 6}};
    MapGrid const grid = MapGrid::read(table, "x", "", "etaMax", {});
    EXPECT_EQ(grid.perRow, 3U);
    EXPECT_EQ(grid.rows(), 2U);
    EXPECT_EQ(grid.y[3], 6);
    std::swap(table.columns[1], table.columns[2]); // a case with gravity along z
    EXPECT_EQ(MapGrid::read(table, "x", "", "etaMax", {}).y[3], 6);
    EXPECT_THROW((void)MapGrid::read(table, "x", "", "eta", {}), CaseError);
    table.columns[0][4] = 1.5;
    EXPECT_THROW((void)MapGrid::read(table, "x", "", "etaMax", {}), CaseError) << "rows differ";
    for (auto& column : table.columns) column.resize(3);
    EXPECT_THROW((void)MapGrid::read(table, "x", "", "etaMax", {}), CaseError) << "one row";
}

} // namespace mpsDem::postGauges
