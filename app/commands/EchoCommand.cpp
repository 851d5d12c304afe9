// SPDX-License-Identifier: Apache-2.0
#include "app/commands/EchoCommand.h"

#include "app/steps/JsonLine.h"
#include "app/steps/SourceArguments.h"
#include "core/sources/PacsSource.h"
#include "ui/base/ErrorText.h"

#include <cstdio>

namespace app {

int runEcho(const QStringList& words)
{
    const Arguments arguments(words, sourceOptions({}), {QStringLiteral("json")});
    if (!arguments.problem().isEmpty())
        return tellUsage("echo", arguments.problem());
    const core::Result<core::PacsSource> source = sourceOf(arguments);
    if (!source)
        return tellUsage("echo", ui::errorText(source.error()));
    if (arguments.rest().size() > 1)
        return tellUsage("echo", QStringLiteral("one source at a time"));
    if (const core::Result<void> answered = core::echoNode(*source, core::Progress()); !answered)
        return tellFailure(answered.error());
    if (arguments.has("json"))
        printJsonLine({{QStringLiteral("node"), source->address()}});
    else
        std::printf("%s answers\n", qUtf8Printable(source->address()));
    return 0;
}

} // namespace app
