#include "io/VtkSeries.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <sstream>

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // its JSON parser still uses them and would print a note
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

namespace fs = std::filesystem;

constexpr Real sameTime = 1e-9; ///< Relative difference of times that count as one.

Real latest(Real time) { return time + sameTime * std::abs(time); }

std::string shortest(Real value)
{
    std::array<char, 64> buffer{};
    auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

/// Number in a name "<name>_000123.vtp", or -1.
std::int64_t indexOf(fs::path const& file)
{
    std::string const stem = file.stem().string();
    std::size_t const begin = stem.find_last_of('_') + 1;
    std::int64_t index = -1;
    auto const [end, error] = std::from_chars(stem.data() + begin, stem.data() + stem.size(), index);
    return error == std::errc() && end == stem.data() + stem.size() ? index : -1;
}

} // namespace

VtkSeries::VtkSeries(fs::path const& caseFolder, std::string name, VtkPrecision precision)
    : folder_(caseFolder / "VTK"),
      name_(std::move(name)),
      precision_(precision)
{
    bool const plain = !name_.empty() && name_.front() != '.' && name_.find_first_of("/\\\"\n\t") == std::string::npos;
    if (!plain) throw CaseError(ExitCode::BadInput, "\"" + name_ + "\" cannot be used as a file name in VTK/");
}

fs::path VtkSeries::seriesFile() const { return folder_ / (name_ + ".vtp.series"); }

void VtkSeries::startAt(Real time)
{
    started_ = true;
    entries_.clear();
    if (!fs::exists(seriesFile())) return;
    try
    {
        entries_ = readSeries(seriesFile());
    }
    catch (CaseError const& error)
    {
        warn(std::string("the series begins anew: ") + error.what());
        return;
    }
    auto const isKept = [&](SeriesEntry const& entry) { return entry.time <= latest(time); };
    auto const firstDropped = std::stable_partition(entries_.begin(), entries_.end(), isKept);
    std::vector<SeriesEntry> const dropped(firstDropped, entries_.end());
    entries_.erase(firstDropped, entries_.end());
    if (dropped.empty()) return;
    writeSeries();
    fs::path const own = folder_ / name_;
    for (SeriesEntry const& entry : dropped)
    {
        if (entry.file.parent_path() == own && indexOf(entry.file) >= 0) removeTree(entry.file);
    }
}

void VtkSeries::write(Real time, PointCloud const& cloud)
{
    fs::path const file = nextFile(time);
    writePointCloud(file, cloud, time, precision_);
    append(time, file);
}

void VtkSeries::write(Real time, SurfaceCells const& surface)
{
    fs::path const file = nextFile(time);
    writeSurface(file, surface, time, precision_);
    append(time, file);
}

fs::path VtkSeries::nextFile(Real time)
{
    if (!started_) startAt(time);
    bool const replaces = !entries_.empty() && std::abs(entries_.back().time - time) <= sameTime * std::abs(time);
    if (replaces) entries_.pop_back();
    std::int64_t last = -1;
    for (SeriesEntry const& entry : entries_) last = std::max(last, indexOf(entry.file));
    std::string digits = std::to_string(last + 1);
    digits.insert(0, digits.size() < 6 ? 6 - digits.size() : 0, '0');
    return folder_ / name_ / (name_ + "_" + digits + ".vtp");
}

void VtkSeries::append(Real time, fs::path const& file)
{
    entries_.push_back({time, file});
    writeSeries();
}

void VtkSeries::writeSeries() const { mpsDem::writeSeries(seriesFile(), entries_); }

void writeSeries(fs::path const& path, std::vector<SeriesEntry> const& entries)
{
    std::string text = "{\"file-series-version\":\"1.0\",\"files\":[";
    char const* separator = "\n";
    for (SeriesEntry const& entry : entries)
    {
        text += separator;
        text += "{\"name\":\"" + entry.file.lexically_relative(parentFolder(path)).generic_string() +
                "\",\"time\":" + shortest(entry.time) + "}";
        separator = ",\n";
    }
    atomicWrite(path, text + "\n]}\n", Durability::Process);
}

std::vector<SeriesEntry> readSeries(fs::path const& path)
{
    std::istringstream text(readBytes(path));
    std::vector<SeriesEntry> entries;
    try
    {
        boost::property_tree::ptree tree;
        boost::property_tree::read_json(text, tree);
        for (auto const& [key, entry] : tree.get_child("files"))
            entries.push_back({entry.get<Real>("time"), parentFolder(path) / entry.get<std::string>("name")});
    }
    catch (boost::property_tree::ptree_error const& error)
    {
        throw CaseError(ExitCode::InputOutput, Location{path.string(), 0, {}}, std::string("no .vtp.series file: ") + error.what());
    }
    return entries;
}

} // namespace mpsDem
