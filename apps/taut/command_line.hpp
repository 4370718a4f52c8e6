// From the words of the command line to the work they ask for.
#pragma once

namespace taut::program {

/// Parses the command line and does the work. Throws InputError if the words make no sense.
void run(int argc, char** argv);

}  // namespace taut::program
