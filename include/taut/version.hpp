// The version of taut, read by CMakeLists.txt from here.
#pragma once

/// "major.minor.patch"
#define TAUT_VERSION "0.1.0"
