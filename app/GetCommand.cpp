// SPDX-License-Identifier: Apache-2.0
#include "app/GetCommand.h"

#include "app/JsonLine.h"
#include "app/NodeArguments.h"
#include "core/pacs/PacsRetrieve.h"
#include "ui/ErrorText.h"

#include <cstdio>

namespace app {

int runGet(const QStringList& words)
{
    const Arguments arguments(words,
        nodeOptions({QStringLiteral("study"), QStringLiteral("series"), QStringLiteral("to"),
            QStringLiteral("move")}),
        {QStringLiteral("json")});
    if (!arguments.problem().isEmpty())
        return tellUsage("get", arguments.problem());
    const core::Result<core::PacsNode> node = nodeOf(arguments);
    if (!node)
        return tellUsage("get", ui::errorText(node.error()));
    if (arguments.rest().size() > 1)
        return tellUsage("get", QStringLiteral("one node at a time"));
    if (!arguments.has("study") || !arguments.has("to"))
        return tellUsage("get", QStringLiteral("--study UID and --to FOLDER are needed"));
    core::RetrieveWay way;
    if (arguments.has("move")) {
        way.movePort = arguments.value("move").toInt();
        if (*way.movePort < 1 || *way.movePort > 65535)
            return tellUsage("get", QStringLiteral("--move takes a port"));
    }
    const QString folder = arguments.value("to");
    const core::Result<core::Retrieved> done = core::retrieve(*node,
        {.studyUid = arguments.value("study"), .seriesUid = arguments.value("series")}, folder, way,
        core::Progress());
    if (!done)
        return tellFailure(done.error());
    if (arguments.has("json")) {
        printJsonLine({{QStringLiteral("folder"), folder},
            {QStringLiteral("received"), done->received}, {QStringLiteral("kept"), done->kept}});
    } else {
        std::printf(
            "%s  %d received, %d were here\n", qUtf8Printable(folder), done->received, done->kept);
    }
    return 0;
}

} // namespace app
