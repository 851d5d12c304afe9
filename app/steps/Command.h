// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace app {

class Arguments;

/// An option of a verb: `--name VALUE`, or `--name` alone.
struct Option {
    const char* name; ///< without "--"
    const char* value; ///< placeholder of the value in help; null: it takes none
    const char* help; ///< a clause
};

/// One verb of the command line, e.g. `burin info`. Each has its own pair of files.
struct Command {
    const char* name;
    const char* words = ""; ///< the arguments besides options
    const char* usage; ///< arguments and options, in one line
    const char* summary; ///< a sentence
    std::vector<Option> options{};
    bool needsWindow = false; ///< a QApplication instead of a QCoreApplication
    /// Runs the command. The arguments are valid: every option is one of the above, has a value if
    /// it takes one, and occurs once.
    /// @return the exit status: 0 done, 1 failed (reported on stderr), 2 wrong arguments
    int (*run)(const Arguments& arguments) = nullptr;
    const char* fontsFor = nullptr; ///< an option that needs fonts, but no display
};

/// Appends more options.
[[nodiscard]] inline std::vector<Option> operator+(
    std::vector<Option> options, const std::vector<Option>& more)
{
    options.insert(options.end(), more.begin(), more.end());
    return options;
}

} // namespace app
