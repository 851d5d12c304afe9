// SPDX-License-Identifier: Apache-2.0
#include "app/commands/pacs/GetCommand.h"

#include "app/steps/JsonLine.h"
#include "app/steps/SourceArguments.h"
#include "core/sources/PacsSource.h"

#include <cstdio>

namespace app {

namespace {

int runGet(const Arguments& arguments)
{
    core::Result<core::PacsSource> source = sourceOf(arguments);
    if (!source)
        return reportUsageError("get", sourceProblem(source.error()));
    if (arguments.rest().size() > 1)
        return reportUsageError("get", QStringLiteral("one source at a time"));
    if (!arguments.has("study") || !arguments.has("to"))
        return reportUsageError("get", QStringLiteral("--study UID and --to FOLDER are needed"));
    if (arguments.has("move")) {
        if (source->isWeb())
            return reportUsageError("get", QStringLiteral("--move is for DICOM nodes"));
        source->movePort = arguments.value("move").toInt();
        if (*source->movePort < 1 || *source->movePort > 65535)
            return reportUsageError("get", QStringLiteral("--move takes a port"));
    }
    const QString folder = arguments.value("to");
    const core::Result<core::Retrieved> done = core::retrieve(*source,
        {.studyUid = arguments.value("study"), .seriesUid = arguments.value("series")}, folder,
        core::Progress());
    if (!done)
        return reportFailure(done.error());
    if (arguments.has("json")) {
        printJsonLine({{QStringLiteral("folder"), folder},
            {QStringLiteral("received"), done->received}, {QStringLiteral("kept"), done->kept}});
    } else {
        std::printf(
            "%s  %d received, %d were here\n", qUtf8Printable(folder), done->received, done->kept);
    }
    return 0;
}

} // namespace

const Command getCommand{.name = "get",
    .words = "SOURCE",
    .usage = "SOURCE --study UID [--series UID] --to FOLDER [--move PORT] [--json]",
    .summary = "downloads a study or series into a new folder, which is there only when it is "
               "whole; a download that broke off goes on; with --move the node brings them to that "
               "port (C-MOVE) instead of handing them over (C-GET)",
    .options =
        std::vector<Option>{{"study", "UID", "the study to download"},
            {"series", "UID", "downloads only this series of it"},
            {"to", "FOLDER", "a new folder, which is there only when it is whole"},
            {"move", "PORT",
                "the node brings them to that port (C-MOVE) instead of handing them over (C-GET)"},
            {"json", nullptr, "prints a line of JSON for each result"}}
        + sourceOptions(),
    .run = runGet};

} // namespace app
