#include "io/Table.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "core/Errors.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trim(std::string_view text)
{
    std::size_t const first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Words of a line: parted by commas where there is one, by blanks otherwise.
std::vector<std::string_view> split(std::string_view line)
{
    std::vector<std::string_view> words;
    bool const commas = line.find(',') != std::string_view::npos;
    std::string_view left = trim(line);
    while (!left.empty() || (commas && !words.empty()))
    {
        std::size_t const end = commas ? left.find(',') : left.find_first_of(blanks);
        words.push_back(trim(left.substr(0, end)));
        if (end == std::string_view::npos) break;
        left = commas ? left.substr(end + 1) : trim(left.substr(end));
    }
    return words;
}

std::optional<Real> number(std::string_view word)
{
    if (word.size() > 1 && word.front() == '+') word.remove_prefix(1);
    Real value = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    bool const whole = error == std::errc() && end == word.data() + word.size();
    return whole ? std::optional<Real>(value) : std::nullopt;
}

std::vector<std::string> namesOf(std::string_view line)
{
    std::vector<std::string> names;
    for (std::string_view word : split(line))
    {
        if (word.size() > 1 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
        names.emplace_back(word);
    }
    return names;
}

/// Takes the lines one after the other.
class TableReader
{
public:
    explicit TableReader(std::string file) { table_.file = std::move(file); }

    void takeLine(std::string_view line)
    {
        ++line_;
        line = trim(line);
        if (line.empty()) return;
        if (line.front() == '#')
        {
            if (table_.columns.empty() && !hasHeading_) names_ = namesOf(line.substr(std::min(line.find_first_not_of('#'), line.size())));
            return;
        }
        auto const words = split(line);
        bool const heading =
            table_.columns.empty() && !hasHeading_ && std::none_of(words.begin(), words.end(), [](auto w) { return number(w); });
        if (heading)
            takeHeading(line);
        else
            takeRow(words);
    }

    Table finish()
    {
        if (table_.columns.empty() && hasHeading_) table_.columns.resize(names_.size());
        if (table_.columns.empty()) throw CaseError(ExitCode::BadInput, Location{table_.file, 0, {}}, "the table has no rows");
        setNames();
        return std::move(table_);
    }

private:
    void takeHeading(std::string_view line)
    {
        hasHeading_ = true;
        names_ = namesOf(line);
    }

    void takeRow(std::vector<std::string_view> const& words)
    {
        Location const where{table_.file, line_, {}};
        if (table_.columns.empty())
        {
            table_.columns.resize(hasHeading_ ? names_.size() : words.size());
        }
        if (words.size() != table_.columns.size())
            throw CaseError(ExitCode::BadInput, where,
                            "the row has " + std::to_string(words.size()) + " numbers, the lines before have " +
                                std::to_string(table_.columns.size()));
        for (std::size_t i = 0; i < words.size(); ++i)
        {
            auto const value = number(words[i]);
            if (!value)
                throw CaseError(ExitCode::BadInput, where, "\"" + std::string(words[i]) + "\" is no number",
                                "columns are parted by blanks or commas, decimals by a point");
            table_.columns[i].push_back(*value);
        }
    }

    void setNames()
    {
        table_.names = names_;
        if (names_.size() == table_.columns.size()) return;
        table_.names.clear();
        for (std::size_t i = 1; i <= table_.columns.size(); ++i) table_.names.push_back("column" + std::to_string(i));
    }

    Table table_;
    std::vector<std::string> names_;
    bool hasHeading_ = false;
    int line_ = 0;
};

} // namespace

bool Table::has(std::string const& name) const { return std::find(names.begin(), names.end(), name) != names.end(); }

std::vector<Real> const& Table::column(std::string const& name) const
{
    auto const found = std::find(names.begin(), names.end(), name);
    require(found != names.end(), Location{file, 0, {}}, "there is no column \"" + name + "\"", knownWords("columns", name, names));
    return columns[static_cast<std::size_t>(found - names.begin())];
}

Table readTable(std::filesystem::path const& path)
{
    std::string const text = readBytes(path);
    std::string_view left = text;
    if (left.substr(0, 3) == "\xEF\xBB\xBF") left.remove_prefix(3);
    TableReader reader(path.string());
    while (!left.empty())
    {
        std::size_t const end = left.find_first_of("\n\r");
        reader.takeLine(left.substr(0, end));
        if (end == std::string_view::npos) break;
        bool const both = left.substr(end, 2) == "\r\n";
        left.remove_prefix(end + (both ? 2 : 1));
    }
    return reader.finish();
}

} // namespace mpsDem
