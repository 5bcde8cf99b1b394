#pragma once

#include <ostream>
#include <string>

namespace mpsDem {

/// Notes and warnings about input that a program reads more than once (a surface, for its shape and for its mass): each text is shown the first
/// time only.
void infoOnce(std::string const& text);
void warnOnce(std::string const& text);

/// A warning of what may happen in every step: shows the 1st, 10th, 100th ... warning of the key, with its number from the second one shown.
void warnSeldom(std::string const& text, std::string const& key);

/// One line for each key of warnSeldom() that has come up more often than once: "Warnings in all, <key>: 1234".
void tellSeldom(std::ostream& os);

/// Shows them again from now on (tests).
void forgetShown();

} // namespace mpsDem
