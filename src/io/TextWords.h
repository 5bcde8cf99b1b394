#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/Types.h"

namespace mpsDem {

/// The words of a text one after the other, with the line of each. A byte order mark at its begin does not count.
class TextWords
{
public:
    explicit TextWords(std::string_view text);

    /// Goes to the next word; an empty one at the end of the text.
    void next();
    /// Leaves out what follows in this line.
    void skipLine();

    [[nodiscard]] std::string_view word() const { return word_; }
    [[nodiscard]] bool done() const { return word_.empty(); }
    /// Of the word; the first line is 1.
    [[nodiscard]] int line() const { return wordLine_; }
    /// Whether the word is this one, given in small letters, in small or capital letters.
    [[nodiscard]] bool is(std::string_view lowerCase) const;
    /// The word as a number, "nan" and "inf" among them; none where it is no number.
    [[nodiscard]] std::optional<Real> number() const;
    /// The word in quotes for a message, odd characters and length tamed; "the file ends" at the end.
    [[nodiscard]] std::string shown() const;

private:
    std::string_view rest_, word_;
    int line_ = 1, wordLine_ = 1;
};

} // namespace mpsDem
