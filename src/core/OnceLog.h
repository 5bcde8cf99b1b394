#pragma once

#include <string>

namespace mpsDem {

/// Notes and warnings about input that a program reads more than once (a surface, for its shape and for its mass): each text is shown the first
/// time only.
void infoOnce(std::string const& text);
void warnOnce(std::string const& text);

/// Shows them again from now on (tests).
void forgetShown();

} // namespace mpsDem
