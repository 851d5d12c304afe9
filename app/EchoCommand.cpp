// SPDX-License-Identifier: Apache-2.0
#include "app/EchoCommand.h"

#include "app/JsonLine.h"
#include "app/NodeArguments.h"
#include "core/pacs/PacsQuery.h"
#include "ui/ErrorText.h"

#include <cstdio>

namespace app {

int runEcho(const QStringList& words)
{
    const Arguments arguments(words, nodeOptions({}), {QStringLiteral("json")});
    if (!arguments.problem().isEmpty())
        return tellUsage("echo", arguments.problem());
    const core::Result<core::PacsNode> node = nodeOf(arguments);
    if (!node)
        return tellUsage("echo", ui::errorText(node.error()));
    if (arguments.rest().size() > 1)
        return tellUsage("echo", QStringLiteral("one node at a time"));
    if (const core::Result<void> answered = core::echoNode(*node, core::Progress()); !answered)
        return tellFailure(answered.error());
    if (arguments.has("json"))
        printJsonLine({{QStringLiteral("node"), node->name()}});
    else
        std::printf("%s answers\n", qUtf8Printable(node->name()));
    return 0;
}

} // namespace app
