// From the words of the command line to the work they ask for.
#pragma once

namespace taut::program {

/// Parses and does it. Throws InputError for words that make no sense.
void run(int argc, char** argv);

}  // namespace taut::program
