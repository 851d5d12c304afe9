// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// One verb of the command line, e.g. `burin info`. Each has its own pair of files.
struct Command {
    const char* name;
    const char* usage; ///< arguments, one line
    const char* summary; ///< one line
    bool needsWindow; ///< a QApplication instead of a QCoreApplication
    /// @return the exit status: 0 done, 1 failed (told on stderr), 2 wrong arguments
    int (*run)(const QStringList& arguments);
    const char* fontsFor = nullptr; ///< an option that needs fonts, though no display
};

/// The command line up to its verb: help, version, dispatch.
int runCommandLine(int argc, char** argv);

} // namespace app
