// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace app {

class Arguments;

/// What a verb takes besides its words: `--name VALUE`, or `--name` alone.
struct Option {
    const char* name; ///< without "--"
    const char* value; ///< what stands for the value in help; null: it takes none
    const char* help; ///< a clause
};

/// One verb of the command line, e.g. `burin info`. Each has its own pair of files.
struct Command {
    const char* name;
    const char* words = ""; ///< what it takes besides options
    const char* usage; ///< words and options, one line
    const char* summary; ///< a sentence
    std::vector<Option> options{};
    bool needsWindow = false; ///< a QApplication instead of a QCoreApplication
    /// Arguments are sound: every option is one of the above, has a value where it takes one, and
    /// is given once. @return the exit status: 0 done, 1 failed (told on stderr), 2 wrong arguments
    int (*run)(const Arguments& arguments) = nullptr;
    const char* fontsFor = nullptr; ///< an option that needs fonts, though no display
};

/// More options behind these.
[[nodiscard]] inline std::vector<Option> operator+(
    std::vector<Option> options, const std::vector<Option>& more)
{
    options.insert(options.end(), more.begin(), more.end());
    return options;
}

} // namespace app
