#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/Errors.h"

namespace mpsDem {

/// Models of one kind, chosen by a word of a dictionary.
///
/// Registration is explicit (each library has a `register...` function), so nothing depends on static initialisation.
/// @tparam Base  Abstract class of the kind.
/// @tparam Args  What every constructor of the kind takes.
template <class Base, class... Args>
class Registry
{
public:
    using Maker = std::function<std::unique_ptr<Base>(Args...)>;

    /// @param kind    One model, e.g. "contact law".
    /// @param plural  Several, e.g. "contact laws".
    Registry(std::string kind, std::string plural) : kind_(std::move(kind)), plural_(std::move(plural)) {}

    /// Adds a model, or replaces the one of the same name.
    void add(std::string const& name, Maker maker) { makers_[name] = std::move(maker); }

    /// Names of all models, in alphabetical order.
    [[nodiscard]] std::vector<std::string> names() const
    {
        std::vector<std::string> all;
        for (auto const& [name, maker] : makers_) all.push_back(name);
        return all;
    }

    /// The model `name`; an unknown word is refused with the known ones and the nearest.
    [[nodiscard]] std::unique_ptr<Base> make(std::string const& name, Location const& where, Args... args) const
    {
        auto const found = makers_.find(name);
        require(found != makers_.end(), where, kind_ + " \"" + name + "\" is not known", knownWords(plural_, name, names()));
        return found->second(std::forward<Args>(args)...);
    }

private:
    std::string kind_;
    std::string plural_;
    std::map<std::string, Maker> makers_;
};

} // namespace mpsDem
