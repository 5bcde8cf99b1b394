#include "postGauges/Text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <set>
#include <string_view>

namespace mpsDem::postGauges {

namespace {

std::string formatted(char const* format, int digits, Real value)
{
    std::array<char, 400> buffer{};
    int const length = std::snprintf(buffer.data(), buffer.size(), format, digits, value);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

template <class Range>
void addValues(std::string& table, Range const& values)
{
    bool first = true;
    for (Real const value : values)
    {
        if (!first) table += ' ';
        table += value != value ? std::string("nan") : number(value, 10);
        first = false;
    }
    table += '\n';
}

} // namespace

std::string number(Real value, int digits) { return formatted("%.*g", digits, value); }

std::string fixedNumber(Real value, int decimals) { return formatted("%.*f", decimals, value); }

int decimalsThatDiffer(std::vector<Real> const& values, int lowest)
{
    std::set<Real> const different(values.begin(), values.end());
    for (int decimals = lowest; decimals < 9; ++decimals)
    {
        std::set<std::string> texts;
        for (Real const value : different) texts.insert(fixedNumber(value, decimals));
        if (texts.size() == different.size()) return decimals;
    }
    return 9;
}

void addRow(std::string& table, std::initializer_list<Real> values) { addValues(table, values); }

void addRow(std::string& table, std::vector<Real> const& values) { addValues(table, values); }

std::string quoted(std::string const& text)
{
    std::string result = "'";
    for (char const c : text)
    {
        bool const control = static_cast<unsigned char>(c) < 32;
        result += control ? ' ' : c;
        if (c == '\'') result += c;
    }
    return result + "'";
}

std::string plain(std::string const& text)
{
    constexpr std::string_view special = "_^{}@&~\\";
    std::string result;
    for (char const c : text)
    {
        if (special.find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

std::string frameName(std::string const& name, std::size_t k)
{
    std::string digits = std::to_string(k);
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    return name + "_" + digits;
}

bool isFileName(std::string const& name)
{
    constexpr std::string_view signs = "_-+.=,";
    auto const fits = [&](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || signs.find(c) != std::string_view::npos; };
    return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), fits);
}

} // namespace mpsDem::postGauges
