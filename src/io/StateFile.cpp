#include "io/StateFile.h"

#include <bit>
#include <cstring>
#include <string_view>

#include "core/Errors.h"
#include "io/Crc32c.h"
#include "io/OutputFile.h"

namespace mpsDem {

namespace {

static_assert(std::endian::native == std::endian::little, "the format is little endian");

constexpr std::string_view magic = "mpsDemS1";

template <class T>
std::string_view bytesOf(T const& value)
{
    return {reinterpret_cast<char const*>(&value), sizeof(T)};
}

template <class T>
std::string_view bytesOf(std::vector<T> const& values)
{
    return {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(T)};
}

/// Appends to a file and keeps the checksums of all data and of the block at hand.
///
/// A checksum that follows its own data leaves a remainder that does not depend on the data: the checksum of all must leave those of the
/// blocks out, or it would be the same for every file with blocks of these lengths.
struct Writer
{
    OutputFile file;
    std::uint32_t dataCrc = 0;
    std::uint32_t blockCrc = 0;

    void put(std::string_view bytes)
    {
        file.write(bytes);
        dataCrc = crc32c(bytes, dataCrc);
        blockCrc = crc32c(bytes, blockCrc);
    }

    void putBlock(std::string const& name, State::Block const& block)
    {
        auto const size = std::visit([](auto const& values) { return values.size(); }, block);
        blockCrc = 0;
        std::string head;
        head += bytesOf(std::uint64_t{name.size()});
        head += name;
        head += bytesOf(std::uint64_t{block.index()});
        head += bytesOf(std::uint64_t{size});
        put(head);
        std::visit([this](auto const& values) { put(bytesOf(values)); }, block);
        file.write(bytesOf(std::uint64_t{blockCrc}));
    }
};

/// Takes pieces off the front of the bytes of a file.
struct Reader
{
    std::filesystem::path const& path;
    std::string_view left;
    std::uint32_t dataCrc = 0;

    [[noreturn]] void refuse(std::string const& what) const
    {
        throw CaseError(ExitCode::InputOutput, Location{path.string(), 0, {}}, "saved state is damaged: " + what);
    }

    std::string_view take(std::uint64_t bytes)
    {
        if (bytes > left.size()) refuse("it ends too early");
        std::string_view const piece = left.substr(0, bytes);
        left.remove_prefix(bytes);
        return piece;
    }

    std::uint64_t number()
    {
        std::uint64_t value = 0;
        std::memcpy(&value, take(8).data(), 8);
        return value;
    }

    template <class T>
    std::vector<T> values(std::uint64_t count)
    {
        if (count > left.size() / sizeof(T)) refuse("it ends too early");
        std::vector<T> numbers(count);
        std::string_view const piece = take(count * sizeof(T));
        if (!piece.empty()) std::memcpy(numbers.data(), piece.data(), piece.size());
        return numbers;
    }

    void takeBlock(State& state)
    {
        std::string_view const begin = left;
        std::string const name(take(number()));
        std::uint64_t const kind = number();
        std::uint64_t const count = number();
        if (kind > 1) refuse("block \"" + name + "\" has an unknown kind");
        State::Block block = kind == 0 ? State::Block(values<Real>(count)) : State::Block(values<std::int64_t>(count));
        std::string_view const bytes = begin.substr(0, begin.size() - left.size());
        dataCrc = crc32c(bytes, dataCrc);
        if (number() != crc32c(bytes)) refuse("checksum of block \"" + name + "\" is wrong");
        if (state.has(name)) refuse("block \"" + name + "\" occurs twice");
        state.setBlock(name, std::move(block));
    }
};

std::uint64_t countValues(State const& state)
{
    std::uint64_t values = 0;
    for (auto const& [name, block] : state.blocks()) values += std::visit([](auto const& v) { return std::uint64_t{v.size()}; }, block);
    return values;
}

} // namespace

StateFileSummary writeStateFile(std::filesystem::path const& path, State const& state)
{
    Writer writer{OutputFile(path)};
    std::string head(magic);
    head += bytesOf(std::uint64_t{state.blocks().size()});
    writer.put(head);
    for (auto const& [name, block] : state.blocks()) writer.putBlock(name, block);
    writer.file.sync();
    writer.file.close();
    return {writer.file.bytes(), writer.dataCrc, state.blocks().size(), countValues(state)};
}

State readStateFile(std::filesystem::path const& path, StateFileSummary const& expected)
{
    std::error_code error;
    auto const size = std::filesystem::file_size(path, error);
    if (!error && size != expected.bytes)
        Reader{path, {}}.refuse("it has " + std::to_string(size) + " bytes, the manifest says " + std::to_string(expected.bytes));
    std::string const bytes = readBytes(path);
    Reader reader{path, bytes};
    if (reader.take(magic.size()) != magic) reader.refuse("it is no block file of this format");
    State state;
    std::uint64_t const blocks = reader.number();
    reader.dataCrc = crc32c(std::string_view(bytes).substr(0, magic.size() + 8));
    for (std::uint64_t i = 0; i < blocks; ++i) reader.takeBlock(state);
    if (!reader.left.empty()) reader.refuse("bytes follow the last block");
    if (reader.dataCrc != expected.crc) reader.refuse("it belongs to another manifest: its checksum differs");
    if (blocks != expected.blocks || countValues(state) != expected.values) reader.refuse("its counts are not those of the manifest");
    return state;
}

} // namespace mpsDem
