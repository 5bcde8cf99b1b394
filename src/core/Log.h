#pragma once

#include <ostream>
#include <string>

namespace mpsDem {

/// Standard output of the master rank: the log that foamLog and PyFoam read. Other ranks write nowhere.
std::ostream& info();

/// Prints "--> FOAM Warning : text" on standard output, at most `limit` times per `text` given the same `key` (0: no limit).
void warn(std::string const& text, std::string const& key = {}, int limit = 0);

/// Number of warnings so far, suppressed ones included.
int warningCount();

/// Silences info() (ranks other than the master, tests).
void muteLog(bool mute);

} // namespace mpsDem
