#include "core/dictionary/Printer.h"
#include "core/dictionary/Reader.h"

namespace mpsDem::dictionary {

namespace {

/// Builds dictionaries out of the tokens of an entry; macros and directives are expanded already.
class ItemBuilder
{
public:
    ItemBuilder(Entry const& entry, std::string scopedName) : entry_(entry), scopedName_(std::move(scopedName)) {}

    DictItems build()
    {
        DictItems items;
        bool const counted = !atEnd() && now().kind == TokenKind::Integer;
        std::int64_t const count = counted ? now().integer : 0;
        if (counted) ++next_;
        require(!atEnd() && now().isPunctuation('('), where(), "a list of dictionaries is expected", "( name { ... } name { ... } )");
        for (++next_; !closes(')');)
        {
            std::string name;
            if (now().isName()) name = entry_.tokens[next_++].text;
            require(!atEnd() && now().isPunctuation('{'), where(), "the items of this list must be dictionaries",
                    "( name { ... } name { ... } )");
            items.emplace_back(name, node(scopedName_ + "." + (name.empty() ? std::to_string(items.size()) : name)));
        }
        ++next_;
        bool const right = !counted || count == static_cast<std::int64_t>(items.size());
        require(right, where(), "the list holds " + std::to_string(items.size()) + " values, not " + std::to_string(count));
        require(atEnd(), where(), "something follows the list", "is a ';' missing behind ')'?");
        return items;
    }

private:
    [[nodiscard]] bool atEnd() const { return next_ >= entry_.tokens.size(); }
    [[nodiscard]] Token const& now() const { return entry_.tokens[next_]; }
    [[nodiscard]] Location where() const { return {*entry_.file, atEnd() ? entry_.line : now().line, scopedName_}; }

    [[nodiscard]] bool closes(char bracket) const
    {
        require(!atEnd(), where(), std::string("'") + bracket + "' is missing");
        return now().isPunctuation(bracket);
    }

    NodePointer node(std::string const& name)
    {
        auto made = std::make_shared<Dictionary::Node>();
        made->scopedName = name;
        made->file = entry_.file;
        made->line = now().line;
        for (++next_; !closes('}');)
        {
            if (now().isPunctuation(';'))
            {
                ++next_;
                continue;
            }
            Entry entry = keyword(*made);
            require(!made->findExact(entry.key), made->where(entry), "the entry \"" + shown(entry.key) + "\" is there already",
                    "one of each");
            made->append(std::move(entry));
        }
        ++next_;
        return made;
    }

    Entry keyword(Dictionary::Node const& parent)
    {
        require(now().isName(), where(), "a keyword is expected, not " + shown(tokensText({now()})));
        Entry entry;
        entry.key = now().text;
        entry.quoted = now().kind == TokenKind::Text;
        entry.line = now().line;
        entry.file = entry_.file;
        bool const code = entry.key == "libs";
        require(!code, where(), "libs is not supported by design: a case is data, never code");
        ++next_;
        if (!atEnd() && now().isPunctuation('{'))
            entry.dict = node(parent.scoped(entry.key));
        else
            readValue(entry);
        return entry;
    }

    void readValue(Entry& entry)
    {
        int depth = 0;
        for (; depth > 0 || !closes(';'); ++next_)
        {
            require(!atEnd(), where(), "';' is missing");
            if (now().opens()) ++depth;
            if (now().closes()) --depth;
            require(depth >= 0, where(), "the entry \"" + shown(entry.key) + "\" has no ';'");
            entry.tokens.push_back(now());
        }
        ++next_;
    }

    Entry const& entry_;
    std::string scopedName_;
    std::size_t next_ = 0;
};

} // namespace

DictItems dictItems(Entry const& entry, std::string const& scopedName) { return ItemBuilder(entry, scopedName).build(); }

} // namespace mpsDem::dictionary
