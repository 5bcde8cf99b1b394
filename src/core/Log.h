#pragma once

#include <ostream>
#include <string>

namespace mpsDem {

/// Standard output of the master rank: the log that foamLog and PyFoam read. Other ranks write nowhere.
std::ostream& info();

/// Prints "--> FOAM Warning : text" on standard output, at most `limit` times per `text` given the same `key` (0: no limit), and on standard
/// error too where that goes elsewhere: a log in a file leaves no warning unseen, and none is shown twice.
void warn(std::string const& text, std::string const& key = {}, int limit = 0);

/// Number of warnings so far, suppressed ones included.
int warningCount();

/// Silences info() (ranks other than the master, tests).
void muteLog(bool mute);

} // namespace mpsDem
