#include <array>
#include <charconv>

#include "core/Dictionary.h"
#include "core/dictionary/Missing.h"

namespace mpsDem {

std::vector<std::string> Dictionary::entryTokens(std::string const& key) const
{
    node_->asked.insert(key);
    dictionary::Entry const* const entry = node_->find(key);
    if (!entry) dictionary::refuseMissing(*node_, key, "entry", key + " ...;");
    require(!entry->dict, where(key), key + " must be a value, not a dictionary", key + " ...;");
    std::vector<std::string> all;
    for (dictionary::Token const& token : entry->tokens)
    {
        if (!token.isNumber())
        {
            all.push_back(token.text);
            continue;
        }
        std::array<char, 32> buffer{};
        auto const end =
            std::to_chars(buffer.data(), buffer.data() + buffer.size(), token.number); // shortest text that reads back as it was
        all.emplace_back(buffer.data(), end.ptr);
    }
    return all;
}

} // namespace mpsDem
