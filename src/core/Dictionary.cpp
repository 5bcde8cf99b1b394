#include "core/Dictionary.h"

#include <algorithm>

#include "core/dictionary/Missing.h"
#include "core/dictionary/Printer.h"
#include "core/dictionary/Reader.h"

namespace mpsDem {

using dictionary::Entry;

Dictionary::Dictionary() : node_(std::make_shared<Node>()) {}

Dictionary::Dictionary(std::shared_ptr<Node> node) : node_(std::move(node)) {}

Dictionary Dictionary::fromFile(std::filesystem::path const& path, std::filesystem::path const& caseRoot)
{
    return Dictionary(dictionary::Reader({caseRoot, false, nullptr}).readFile(path));
}

Dictionary Dictionary::fromFileLeniently(std::filesystem::path const& path, std::filesystem::path const& caseRoot,
                                         std::vector<std::string>& warnings)
{
    return Dictionary(dictionary::Reader({caseRoot, true, &warnings}).readFile(path));
}

Dictionary Dictionary::fromText(std::string const& text, std::string const& name)
{
    return Dictionary(dictionary::Reader({{}, false, nullptr}).readText(text, name));
}

void Dictionary::requireHeader(std::string const& expectedClass) const
{
    std::string const example = "FoamFile { version 2.0; format ascii; class " + expectedClass + "; object ...; }";
    Entry const* const header = node_->findExact("FoamFile");
    require(header && header->dict, where(), "the header FoamFile is missing", example);
    require(&node_->entries.front() == header, node_->where(*header), "the header FoamFile must stand at the top of the file");
    Dictionary const entries(header->dict);
    std::string const format = entries.getOr<std::string>("format", "ascii");
    require(format == "ascii", entries.where("format"), "format is " + dictionary::shown(format), "allowed: ascii");
    auto const given = entries.get<std::string>("class");
    require(given == expectedClass, entries.where("class"), "class is " + dictionary::shown(given), "expected: " + expectedClass);
}

bool Dictionary::found(std::string const& key) const
{
    node_->asked.insert(key);
    return node_->find(key) != nullptr;
}

bool Dictionary::isDict(std::string const& key) const
{
    node_->asked.insert(key);
    Entry const* const entry = node_->find(key);
    return entry && entry->dict;
}

Dictionary Dictionary::subDict(std::string const& key) const
{
    node_->asked.insert(key);
    Entry const* const entry = node_->find(key);
    if (!entry) dictionary::refuseMissing(*node_, key, "dictionary", key + " { ... }");
    require(entry->dict != nullptr, where(key), key + " must be a dictionary", key + " { ... }");
    return Dictionary(entry->dict);
}

Dictionary Dictionary::subDictOrEmpty(std::string const& key) const
{
    if (found(key)) return subDict(key);
    auto empty = std::make_shared<Node>();
    empty->scopedName = node_->scoped(key);
    empty->file = node_->file;
    empty->line = node_->line;
    return Dictionary(std::move(empty));
}

std::vector<std::pair<std::string, Dictionary>> Dictionary::getDictList(std::string const& key) const
{
    node_->asked.insert(key);
    Entry* const entry = node_->find(key);
    if (!entry) dictionary::refuseMissing(*node_, key, "entry", key + " ( name { ... } );");
    require(!entry->dict, where(key), key + " must be a list of dictionaries", key + " ( name { ... } );");
    if (!entry->itemsMade) entry->items = dictionary::dictItems(*entry, node_->scoped(key));
    entry->itemsMade = true;
    std::vector<std::pair<std::string, Dictionary>> list;
    for (auto const& [name, node] : entry->items) list.emplace_back(name, Dictionary(node));
    return list;
}

std::vector<std::string> Dictionary::keys() const
{
    std::vector<std::string> all = node_->keys();
    if (node_->scopedName.empty()) std::erase(all, "FoamFile");
    return all;
}

std::vector<std::string> Dictionary::dictKeys() const
{
    std::vector<std::string> all = keys();
    std::erase_if(all, [&](std::string const& key) { return !node_->findExact(key)->dict; });
    return all;
}

void Dictionary::ignore(std::string const& key) const { node_->ignored.insert(key); }

void Dictionary::refuseMisspelt(std::vector<std::string> const& keys) const
{
    for (std::string const& key : keys)
        if (!node_->find(key) && dictionary::misspelt(*node_, key)) dictionary::refuseMissing(*node_, key, "entry", {});
}

Location Dictionary::where(std::string const& key) const
{
    Location place = node_->where();
    if (key.empty()) return place;
    Entry const* const entry = node_->find(key);
    if (entry) return node_->where(*entry);
    place.entry = node_->scoped(key);
    return place;
}

std::string const& Dictionary::name() const { return node_->scopedName; }

namespace {

/// Whether a macro took the entry's value or something inside it, so that the entry serves the file as a variable.
bool holdsVariable(Entry const& entry)
{
    if (entry.taken) return true;
    if (!entry.dict) return false;
    return std::any_of(entry.dict->entries.begin(), entry.dict->entries.end(), holdsVariable);
}

} // namespace

void Dictionary::requireAllRead() const
{
    for (Entry const& entry : node_->entries)
    {
        bool const header = node_->scopedName.empty() && entry.key == "FoamFile";
        auto const names = [&](std::string const& key) { return key == entry.key || (entry.match && entry.match->matches(key)); };
        if (header || std::any_of(node_->ignored.begin(), node_->ignored.end(), names)) continue;
        bool const known = std::any_of(node_->asked.begin(), node_->asked.end(), names);
        if (!known && holdsVariable(entry)) continue;
        std::string const what = "the entry \"" + dictionary::shown(entry.key) + "\" is not known here";
        require(known, node_->where(entry), what, knownWords("entries", dictionary::shown(entry.key), node_->asked));
        if (entry.dict) Dictionary(entry.dict).requireAllRead();
        for (auto const& [name, item] : entry.items) Dictionary(item).requireAllRead();
    }
}

std::string Dictionary::str() const { return dictionary::nodeText(*node_); }

namespace {

/// The nearest of the keys that stand where `key` was looked for: in the sub-dictionary that it names, else in `node`.
std::string nearestScoped(Dictionary::Node const& node, std::string const& key)
{
    std::size_t const last = key.find_last_of("/.");
    Entry const* const parent =
        last == std::string::npos ? nullptr : node.findScoped(key.substr(0, last), key[last], Dictionary::Node::Match::Pattern);
    if (!parent || !parent->dict) return dictionary::didYouMean(key, node.keys());
    return dictionary::didYouMean(key.substr(last + 1), parent->dict->keys());
}

Entry const& scopedEntry(Dictionary::Node const& node, std::string const& scopedKey)
{
    std::string key = scopedKey;
    if (key.starts_with(":") || key.starts_with("/")) key.erase(0, 1);
    Entry const* entry = node.findScoped(key, '/', Dictionary::Node::Match::Pattern);
    if (!entry) entry = node.findScoped(key, '.', Dictionary::Node::Match::Pattern);
    Location place = node.where();
    place.entry = scopedKey;
    require(entry != nullptr, place, "Cannot find entry " + scopedKey, nearestScoped(node, key));
    return *entry;
}

} // namespace

std::string Dictionary::entryText(std::string const& scopedKey) const
{
    Entry const& entry = scopedEntry(*node_, scopedKey);
    if (!entry.dict) return dictionary::tokensText(entry.tokens);
    return "{\n" + dictionary::nodeText(*entry.dict, 1) + "}";
}

std::string Dictionary::entryStatement(std::string const& scopedKey) const { return dictionary::entryText(scopedEntry(*node_, scopedKey)); }

std::vector<std::string> Dictionary::entryKeywords(std::string const& scopedKey) const
{
    if (scopedKey.empty()) return dictionary::printedKeys(*node_);
    Entry const& entry = scopedEntry(*node_, scopedKey);
    require(entry.dict != nullptr, node_->where(entry), scopedKey + " is no dictionary: it has no keywords");
    return dictionary::printedKeys(*entry.dict);
}

} // namespace mpsDem
