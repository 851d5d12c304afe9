// SPDX-License-Identifier: Apache-2.0
#include "app/CommandLine.h"

#include "app/Version.h"
#include "app/commands/BatchCommand.h"
#include "app/commands/CompareCommand.h"
#include "app/commands/DemoCommand.h"
#include "app/commands/EditsCommand.h"
#include "app/commands/HistoryCommand.h"
#include "app/commands/InfoCommand.h"
#include "app/commands/MeshCommand.h"
#include "app/commands/ReplayCommand.h"
#include "app/commands/RunCommand.h"
#include "app/commands/pacs/EchoCommand.h"
#include "app/commands/pacs/FindCommand.h"
#include "app/commands/pacs/GetCommand.h"
#include "app/commands/pacs/SendCommand.h"
#include "app/steps/Arguments.h"
#include "app/window/DisplayNeeded.h"
#include "app/window/GuardedApplication.h"
#include "app/window/HandlesNeeded.h"
#include "app/window/OpenCommand.h"
#include "app/window/PrivateSettings.h"
#include "core/base/Guarded.h"
#include "core/base/files/SystemFile.h"

#include <QApplication>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include <poll.h>
#include <unistd.h>

namespace app {

namespace {

std::span<const Command* const> commands()
{
    static const std::vector<const Command*> table{&batchCommand, &compareCommand, &demoCommand,
        &echoCommand, &editsCommand, &findCommand, &getCommand, &historyCommand, &infoCommand,
        &meshCommand, &openCommand, &replayCommand, &runCommand, &sendCommand};
    return table;
}

void printHelp()
{
    std::printf("burin %s — segmentation workstation (research use; not a medical device)\n\n",
        BURIN_VERSION);
    for (const Command* command : commands())
        std::printf("  burin %s %s\n      %s\n", command->name, command->usage, command->summary);
    std::printf("\nburin COMMAND --help says what each option means.\n");
}

/// Whether whoever reads the output has closed it, as `head` does when it has had enough.
bool isOutputClosed()
{
    pollfd output{.fd = STDOUT_FILENO, .events = 0, .revents = 0};
    return ::poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

/// What was printed may be somebody's file, of which only the end tells whether it is whole.
/// @return the status, or that of a failure if what was printed is not
int afterOutput(int status)
{
    const bool isFlushed = std::fflush(stdout) == 0;
    const int error = errno;
    if ((isFlushed && std::ferror(stdout) == 0) || isOutputClosed())
        return status;
    // Of what failed earlier nobody has kept the reason.
    const QString why = isFlushed ? QString() : QStringLiteral(": ") + core::systemReason(error);
    std::fprintf(
        stderr, "burin: not all that it printed could be written%s\n", qUtf8Printable(why));
    return status == 0 ? 1 : status;
}

} // namespace

int runCommandLine(int argc, char** argv)
{
    const char* verb = argc > 1 ? argv[1] : "--help";
    for (const Command* known : commands()) {
        const Command& command = *known;
        if (std::strcmp(verb, command.name) != 0)
            continue;
        std::unique_ptr<QCoreApplication> application;
        const std::span<char*> words(argv + 1, argv + argc);
        const auto isFontsFor = [&command](const char* word) {
            const std::size_t length = command.fontsFor ? std::strlen(command.fontsFor) : 0;
            return length > 0 && std::strncmp(word, command.fontsFor, length) == 0
                && (word[length] == '\0' || word[length] == '=');
        };
        const bool needsFonts = std::any_of(words.begin(), words.end(), isFontsFor);
        const bool needsWindow = command.needsWindow
            && std::none_of(words.begin(), words.end(),
                [](const char* word) { return std::strcmp(word, "--help") == 0; });
        if (needsFonts)
            qputenv("QT_QPA_PLATFORM", "offscreen");
        if (needsWindow) {
            if (const QString why = whyNoWindowForHandles(); !why.isEmpty()) {
                std::fprintf(stderr, "burin: %s\n", qUtf8Printable(why));
                return EXIT_FAILURE;
            }
        }
        int status = 0;
        const core::Result<void> ran = core::guarded([&] {
            if (needsWindow) {
                const DisplayNeeded display;
                application = std::make_unique<GuardedApplication>(argc, argv);
            } else if (needsFonts) {
                application = std::make_unique<QGuiApplication>(argc, argv);
            } else {
                application = std::make_unique<QCoreApplication>(argc, argv);
            }
            QCoreApplication::setApplicationName(QStringLiteral("burin"));
            QCoreApplication::setOrganizationName(QStringLiteral("burin"));
            QCoreApplication::setApplicationVersion(QStringLiteral(BURIN_VERSION));
            if (needsWindow)
                keepSettingsPrivate();
            const Arguments arguments(command, application->arguments().mid(2));
            if (arguments.askForHelp())
                std::printf("%s", qUtf8Printable(arguments.helpText()));
            else if (!arguments.problem().isEmpty())
                status = reportUsageError(command.name, arguments.problem());
            else
                status = command.run(arguments);
        });
        return afterOutput(ran ? status : reportFailure(ran.error()));
    }
    if (std::strcmp(verb, "--version") == 0) {
        std::printf("burin %s\n", BURIN_VERSION);
        return afterOutput(0);
    }
    for (const char* word : {"--help", "-h", "help"}) {
        if (std::strcmp(verb, word) == 0) {
            printHelp();
            return afterOutput(0);
        }
    }
    std::fprintf(stderr, "burin: unknown command '%s' (burin --help)\n", verb);
    return 2;
}

} // namespace app
