#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "io/OutputFile.h"
#include "postGauges/ConvergencePlot.h"

namespace mpsDem::postGauges {

namespace {

std::vector<std::string> wordsOf(std::string line)
{
    for (char& c : line)
        if (c == ',' || c == '\t' || c == '\r') c = ' ';
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

constexpr std::array<char const*, 6> columnNames = {"scheme", "spacing", "error", "spread", "seconds", "failed"};

/// Where each known column stands in a line.
using Places = std::array<std::size_t, 6>;

std::optional<Places> placesOf(std::vector<std::string> const& names)
{
    Places places{};
    for (std::size_t k = 0; k < columnNames.size(); ++k)
    {
        std::size_t i = 0;
        while (i < names.size() && names[i] != columnNames[k]) ++i;
        if (i == names.size()) return std::nullopt;
        places[k] = i;
    }
    return places;
}

Real numberOf(std::string const& word, Location const& where, char const* column)
{
    if (word == "-") return std::numeric_limits<Real>::quiet_NaN();
    Real value = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    bool const whole = error == std::errc() && end == word.data() + word.size();
    require(whole, where, std::string(column) + ": \"" + word + "\" is no number", "a number, or - where there is none");
    return value;
}

StudyRun runOf(std::vector<std::string> const& words, Places const& places, Location const& where)
{
    StudyRun run;
    auto const value = [&](std::size_t k) { return numberOf(words[places[k]], where, columnNames[k]); };
    run.scheme = words[places[0]];
    run.spacing = value(1);
    run.error = value(2);
    run.spread = value(3);
    run.seconds = value(4);
    Real const failed = value(5);
    require(failed == 0 || failed == 1, where, "failed must be 0 or 1");
    run.failed = failed == 1;
    bool const complete = run.failed || (run.error > 0 && run.seconds > 0);
    require(complete, where, "error and seconds must be above zero in a run that did not fail");
    require(run.spacing > 0, where, "spacing must be above zero");
    return run;
}

} // namespace

std::vector<StudyRun> readStudy(std::filesystem::path const& path)
{
    std::istringstream text(readBytes(path));
    Places places = {0, 1, 2, 3, 4, 5};
    std::size_t columns = columnNames.size();
    std::vector<StudyRun> runs;
    int number = 0;
    for (std::string line; std::getline(text, line);)
    {
        Location const where{path.string(), ++number, {}};
        bool const comment = line.find_first_not_of(" \t") != std::string::npos && line[line.find_first_not_of(" \t")] == '#';
        if (comment) line.erase(0, line.find('#') + 1);
        auto const words = wordsOf(line);
        auto const named = runs.empty() ? placesOf(words) : std::nullopt;
        if (named)
        {
            places = *named;
            columns = words.size();
        }
        if (named || comment || words.empty()) continue;
        require(words.size() == columns, where, "the row has " + std::to_string(words.size()) + " words, not " + std::to_string(columns),
                "scheme spacing error spread seconds failed");
        runs.push_back(runOf(words, places, where));
    }
    require(!runs.empty(), Location{path.string(), 0, {}}, "the table has no rows", "scheme spacing error spread seconds failed");
    return runs;
}

} // namespace mpsDem::postGauges
