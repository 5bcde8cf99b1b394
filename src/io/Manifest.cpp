#include "io/Manifest.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/Errors.h"
#include "io/Crc32c.h"

namespace mpsDem {

namespace {

constexpr std::string_view title = "mpsDem saved state";
constexpr std::int64_t formatVersion = 1;

std::string shortest(Real value)
{
    std::array<char, 64> buffer{};
    auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return {buffer.data(), end};
}

std::string hexadecimal(Real value)
{
    std::array<char, 64> buffer{};
    auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value), std::chars_format::hex).ptr;
    return (std::signbit(value) ? "-0x" : "0x") + std::string(buffer.data(), end);
}

std::string const& oneLine(std::string const& text)
{
    expect(text.find_first_of("\r\n") == std::string::npos, "manifest: a text has several lines");
    return text;
}

/// Takes lines "key value" off the front of the text.
struct Lines
{
    std::filesystem::path const& where;
    std::string_view left;
    int line = 0;

    [[noreturn]] void refuse(std::string const& what) const
    {
        throw CaseError(ExitCode::InputOutput, Location{where.string(), line, {}}, "manifest is damaged: " + what);
    }

    std::string_view next()
    {
        ++line;
        std::size_t const end = left.find('\n');
        if (end == std::string_view::npos) refuse("it ends too early");
        std::string_view const text = left.substr(0, end);
        left.remove_prefix(end + 1);
        return text;
    }

    std::string_view value(std::string_view key)
    {
        std::string_view text = next();
        bool const fits = text.size() > key.size() && text.substr(0, key.size()) == key && text[key.size()] == ' ';
        if (!fits) refuse("\"" + std::string(key) + "\" is expected");
        return text.substr(key.size() + 1);
    }

    template <class T>
    T integer(std::string_view text, int base = 10)
    {
        T number{};
        auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
        if (error != std::errc() || end != text.data() + text.size()) refuse("\"" + std::string(text) + "\" is no integer");
        return number;
    }

    /// The hexadecimal form at the front of "0x1.8p+0 1.5".
    Real time(std::string_view text)
    {
        bool const negative = !text.empty() && text.front() == '-';
        if (negative) text.remove_prefix(1);
        if (text.substr(0, 2) != "0x") refuse("the time has no hexadecimal form");
        text.remove_prefix(2);
        Real number = 0;
        auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::hex);
        if (error != std::errc() || end == text.data() + text.size() || *end != ' ') refuse("the time has no hexadecimal form");
        return negative ? -number : number;
    }
};

/// Everything before the last line, whose checksum that line must state to the letter.
std::string_view checkedBody(std::string const& text, Lines const& lines)
{
    std::size_t const tail = std::string_view("crc32c 00000000\n").size();
    if (text.size() < tail) lines.refuse("it ends too early");
    std::string_view const body = std::string_view(text).substr(0, text.size() - tail);
    if (text.substr(body.size()) != "crc32c " + crcText(crc32c(body)) + "\n") lines.refuse("its checksum is wrong");
    return body;
}

} // namespace

std::string Manifest::text() const
{
    std::string text(title);
    auto const add = [&](std::string const& key, std::string const& value) { text += "\n" + key + " " + oneLine(value); };
    add("formatVersion", std::to_string(formatVersion));
    add("sequence", std::to_string(info.sequence));
    add("step", std::to_string(info.step));
    add("time", hexadecimal(info.time) + " " + shortest(info.time));
    add("codeVersion", info.codeVersion);
    add("inputHash", info.inputHash);
    add("effects", std::to_string(info.effects.size()));
    for (std::string const& effect : info.effects) add("effect", effect);
    add("blocks", std::to_string(file.blocks));
    add("values", std::to_string(file.values));
    add("bytes", std::to_string(file.bytes));
    add("stateCrc32c", crcText(file.crc));
    text += '\n';
    return text + "crc32c " + crcText(crc32c(text)) + "\n";
}

Manifest Manifest::parse(std::string const& text, std::filesystem::path const& where)
{
    Lines lines{where, text};
    lines.left = checkedBody(text, lines);
    if (lines.next() != title) lines.refuse("\"" + std::string(title) + "\" is expected");
    auto const version = lines.integer<std::int64_t>(lines.value("formatVersion"));
    if (version != formatVersion)
        throw CaseError(ExitCode::InputOutput, Location{where.string(), 2, {}},
                        "saved state has format version " + std::to_string(version) + ", this program reads " +
                            std::to_string(formatVersion),
                        "use the program that wrote it, or run setParticles again");
    Manifest m;
    m.info.sequence = lines.integer<std::int64_t>(lines.value("sequence"));
    m.info.step = lines.integer<std::int64_t>(lines.value("step"));
    m.info.time = lines.time(lines.value("time"));
    m.info.codeVersion = lines.value("codeVersion");
    m.info.inputHash = lines.value("inputHash");
    auto const effects = lines.integer<std::uint64_t>(lines.value("effects"));
    for (std::uint64_t i = 0; i < effects; ++i) m.info.effects.emplace_back(lines.value("effect"));
    m.file.blocks = lines.integer<std::uint64_t>(lines.value("blocks"));
    m.file.values = lines.integer<std::uint64_t>(lines.value("values"));
    m.file.bytes = lines.integer<std::uint64_t>(lines.value("bytes"));
    m.file.crc = lines.integer<std::uint32_t>(lines.value("stateCrc32c"), 16);
    if (!lines.left.empty()) lines.refuse("text follows the last entry");
    return m;
}

} // namespace mpsDem
