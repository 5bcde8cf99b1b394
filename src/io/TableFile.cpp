#include "io/TableFile.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/Errors.h"

namespace mpsDem {

namespace {

/// Number in the given digits, independent of the locale, followed by blanks up to `width`.
std::string cell(Real value, int precision, std::size_t width)
{
    std::array<char, 128> buffer{};
    auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, precision).ptr;
    std::string text(buffer.data(), end);
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string padded(std::string text, std::size_t width)
{
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

void endLine(std::string& line)
{
    line.erase(line.find_last_not_of(' ') + 1);
    line += '\n';
}

} // namespace

TableFile::TableFile(std::filesystem::path const& caseFolder, std::string const& object, std::string const& startTime,
                     std::string const& file, std::vector<std::string> columns, Options options)
    : path_(caseFolder / "postProcessing" / object / startTime),
      file_(file),
      startTime_(startTime),
      columns_(std::move(columns)),
      options_(std::move(options))
{
    for (auto const& name : columns_)
        expect(!name.empty() && name.find_first_of(" \t\r\n,") == std::string::npos, "TableFile: a column name is empty or has blanks");
    for (auto const& line : options_.header)
        expect(line.find_first_of("\r\n") == std::string::npos, "TableFile: a header line has line ends");
    options_.precision = std::clamp(options_.precision, 1, 17);
}

TableFile::TableFile(std::filesystem::path const& caseFolder, std::string const& object, std::string const& startTime,
                     std::string const& file, std::vector<std::string> columns)
    : TableFile(caseFolder, object, startTime, file, std::move(columns), Options())
{}

void TableFile::open()
{
    makeFolder(path_);
    std::filesystem::path free = path_ / (file_ + ".dat");
    for (int i = 1; std::filesystem::exists(std::filesystem::symlink_status(free)); ++i)
        free = path_ / (file_ + "_" + startTime_ + (i > 1 ? "_" + std::to_string(i) : "") + ".dat");
    out_ = std::make_unique<OutputFile>(free, OutputFile::Mode::New);
    path_ = free;
    std::string text;
    for (auto const& line : options_.header) text += "# " + line + "\n";
    std::size_t const width = static_cast<std::size_t>(options_.precision) + 8;
    std::string names = padded("# Time", width);
    for (auto const& name : columns_) names += " " + padded(name, width);
    endLine(names);
    out_->write(text + names);
}

void TableFile::add(Real time, std::span<Real const> values)
{
    expect(values.size() == columns_.size(), "TableFile: the number of values is not the number of columns");
    if (!out_) open();
    std::size_t const width = static_cast<std::size_t>(options_.precision) + 8;
    std::string line = cell(time, options_.precision, width);
    for (Real const value : values) line += " " + cell(value, options_.precision, width);
    endLine(line);
    out_->write(line);
    last_.assign(values.begin(), values.end());
}

void TableFile::printLast(std::ostream& os) const
{
    std::size_t const shown = std::min<std::size_t>(last_.size(), 8);
    for (std::size_t k = 0; k < shown; ++k) os << (k > 0 ? ", " : "") << columns_[k] << " = " << cell(last_[k], 6, 0);
    if (shown < last_.size()) os << ", ... (" << last_.size() << " columns)";
}

} // namespace mpsDem
