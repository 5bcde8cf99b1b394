#include "postGauges/TableSource.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>

#include "core/Log.h"
#include "postGauges/Text.h"

namespace mpsDem::postGauges {

namespace fs = std::filesystem;

namespace {

std::optional<Real> asNumber(std::string const& word)
{
    Real value = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    bool const whole = error == std::errc() && end == word.data() + word.size();
    return whole ? std::optional<Real>(value) : std::nullopt;
}

std::string listed(std::vector<std::string> const& names)
{
    std::string text;
    for (std::string const& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

std::vector<std::string> entriesOf(fs::path const& folder, bool folders)
{
    std::vector<std::string> names;
    std::error_code error;
    for (auto const& entry : fs::directory_iterator(folder, error))
        if (entry.is_directory() == folders) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Start times of an object with their folder names, increasing.
std::vector<std::pair<Real, std::string>> startsOf(fs::path const& objectFolder)
{
    std::vector<std::pair<Real, std::string>> starts;
    for (std::string const& name : entriesOf(objectFolder, true))
        if (auto const time = asNumber(name)) starts.emplace_back(*time, name);
    std::sort(starts.begin(), starts.end());
    return starts;
}

/// The table's name where the object has only one.
std::string onlyFile(fs::path const& startFolder, Location const& where)
{
    std::set<std::string> stems;
    std::string const rerun = "_" + startFolder.filename().string();
    for (std::string const& name : entriesOf(startFolder, false))
    {
        fs::path const path = name;
        std::string stem = path.stem().string();
        std::size_t const suffix = stem.rfind(rerun);
        bool const again = suffix != std::string::npos && fs::exists(startFolder / (stem.substr(0, suffix) + path.extension().string()));
        if (again) stem.erase(suffix);
        if (path.extension() == ".dat" || path.extension() == ".csv") stems.insert(stem + path.extension().string());
    }
    std::vector<std::string> const names(stems.begin(), stems.end());
    require(names.size() == 1, where,
            names.empty() ? startFolder.string() + " holds no table" : "the object has several tables: which one?",
            "file: " + listed(names));
    return names.front();
}

} // namespace

std::string wordOrNumber(Dictionary const& dict, std::string const& key)
{
    if (!dict.found(key)) return dict.get<std::string>(key);
    std::string const text = dict.isDict(key) ? std::string() : dict.entryText(key);
    return asNumber(text) ? text : dict.get<std::string>(key);
}

std::vector<Real> const& columnOf(Table const& table, std::string const& name, Location const& where)
{
    for (std::size_t i = 0; i < table.names.size(); ++i)
    {
        std::string const& known = table.names[i];
        bool const withoutUnit = known.size() > name.size() && known.starts_with(name) && known[name.size()] == '[';
        if (known == name || withoutUnit) return table.columns[i];
    }
    auto const position = asNumber(name);
    for (std::size_t i = 0; position && i < table.columns.size(); ++i)
        if (*position == static_cast<Real>(i + 1)) return table.columns[i];
    throw CaseError(ExitCode::BadInput, where, "there is no column \"" + name + "\" in " + table.file,
                    knownWords("columns", name, table.names));
}

Table joinTables(std::vector<Table> const& tables)
{
    expect(!tables.empty(), "joinTables: no table");
    Table all = tables.front();
    for (std::size_t k = 1; k < tables.size(); ++k)
    {
        Table const& next = tables[k];
        require(next.names == all.names, Location{next.file, 0, {}}, "the columns are not those of " + all.file,
                "startTime latest; or one of the start times");
        if (next.rows() == 0) continue;
        Real const start = next.columns.front().front();
        auto const kept = std::lower_bound(all.columns.front().begin(), all.columns.front().end(), start) - all.columns.front().begin();
        for (std::size_t c = 0; c < all.columns.size(); ++c)
        {
            all.columns[c].resize(static_cast<std::size_t>(kept));
            all.columns[c].insert(all.columns[c].end(), next.columns[c].begin(), next.columns[c].end());
        }
    }
    return all;
}

fs::path newestRun(fs::path const& startFolder, std::string const& file)
{
    fs::path const plainName = file;
    std::string const stem = plainName.stem().string() + "_" + startFolder.filename().string();
    std::string const ending = plainName.extension().string();
    fs::path newest;
    if (fs::is_regular_file(startFolder / file)) newest = startFolder / file;
    for (int run = 1; run < 10000; ++run)
    {
        fs::path const next = startFolder / (stem + (run > 1 ? "_" + std::to_string(run) : "") + ending);
        if (!fs::is_regular_file(next)) break;
        newest = next;
    }
    return newest;
}

TableSource TableSource::read(Dictionary const& dict)
{
    TableSource source;
    source.where = dict.where();
    source.object = dict.getOr<std::string>("object", "");
    source.file = source.object.empty() ? dict.get<std::string>("file") : dict.getOr<std::string>("file", "");
    source.caseFolder = dict.getOr<std::string>("case", "");
    if (!dict.found("startTime")) return source;
    source.startTime = wordOrNumber(dict, "startTime");
    bool const fits = source.startTime == "all" || source.startTime == "latest" || asNumber(source.startTime);
    require(fits, dict.where("startTime"), "startTime \"" + source.startTime + "\" is no time", "allowed: all, latest or a number");
    return source;
}

bool TableSource::isReference() const
{
    fs::path const parts = file;
    return object.empty() && std::find(parts.begin(), parts.end(), "postProcessing") == parts.end();
}

fs::path TableSource::path(PostCase const& postCase) const
{
    return findTable(caseFolder.empty() ? postCase.root : postCase.resolve(caseFolder), file);
}

Table TableSource::load(PostCase const& postCase) const
{
    if (object.empty())
    {
        fs::path const table = path(postCase);
        if (!fs::is_regular_file(table))
        {
            bool const script = fs::is_regular_file(postCase.root / "Allrun");
            throw CaseError(ExitCode::InputOutput, where, "there is no file " + postCase.shown(table),
                            "files there: " + listed(entriesOf(table.parent_path(), false)) +
                                (script ? "; some tables are made by the case's Allrun" : ""));
        }
        return readTable(table);
    }
    fs::path const root = caseFolder.empty() ? postCase.root : postCase.resolve(caseFolder);
    fs::path const folder = root / "postProcessing" / object;
    auto starts = startsOf(folder);
    if (starts.empty())
        throw CaseError(ExitCode::InputOutput, where, "there is no output of \"" + object + "\" in " + postCase.shown(folder.parent_path()),
                        knownWords("objects", object, entriesOf(folder.parent_path(), true)));
    if (startTime == "latest") starts.erase(starts.begin(), starts.end() - 1);
    std::vector<Table> tables;
    std::vector<std::string> names;
    fs::file_time_type written = fs::file_time_type::min();
    for (auto const& [time, name] : starts)
    {
        names.push_back(name);
        auto const wanted = asNumber(startTime);
        if (wanted && *wanted != time) continue;
        fs::path const path = newestRun(folder / name, file.empty() ? onlyFile(folder / name, where) : file);
        if (path.empty()) continue;
        tables.push_back(readTable(path));
        if (fs::last_write_time(path) < written)
            warn(postCase.shown(path) + " is older than the table of an earlier start time: does it belong to another run? (startTime " +
                 names.front() + "; leaves it out)");
        written = fs::last_write_time(path);
    }
    if (tables.empty())
        throw CaseError(ExitCode::InputOutput, where,
                        "\"" + object + "\" has no table " + file + (asNumber(startTime) ? " from " + startTime : ""),
                        "start times: " + listed(names) + "; files: " + listed(entriesOf(folder / names.back(), false)));
    return joinTables(tables);
}

} // namespace mpsDem::postGauges
