#pragma once

// What nearly every file of mpsDem includes through its headers, compiled once (MPSDEM_PRECOMPILED): half of the time of a build is spent
// on reading it. Every file still includes what it uses; tests/Allgate compiles all of them without this one.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
