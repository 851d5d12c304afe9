// SPDX-License-Identifier: Apache-2.0
#include "app/commands/pacs/EchoCommand.h"

#include "app/steps/JsonLine.h"
#include "app/steps/SourceArguments.h"
#include "core/sources/PacsSource.h"

#include <cstdio>

namespace app {

namespace {

int runEcho(const Arguments& arguments)
{
    const core::Result<core::PacsSource> source = sourceOf(arguments);
    if (!source)
        return reportUsageError("echo", sourceProblem(source.error()));
    if (arguments.rest().size() > 1)
        return reportUsageError("echo", QStringLiteral("one source at a time"));
    if (const core::Result<void> answered = core::echoNode(*source, core::Progress()); !answered)
        return reportFailure(answered.error());
    if (arguments.has("json"))
        printJsonLine({{QStringLiteral("node"), source->address()}});
    else
        std::printf("%s answers\n", qUtf8Printable(source->address()));
    return 0;
}

} // namespace

const Command echoCommand{.name = "echo",
    .words = "SOURCE",
    .usage = "SOURCE [--own-title TITLE] [--login-file FILE] [--timeout SECONDS] [--json]",
    .summary = "asks whether a PACS answers; SOURCE is AETITLE@host:port (DICOM), "
               "https://host/dicom-web (DICOMweb) or the name of a source in the settings; this "
               "and find, get and send all take --own-title (BURIN), --login-file (user:password "
               "or Bearer TOKEN, which BURIN_LOGIN may hold instead), --timeout (30), and for TLS "
               "--tls-authority FILE [--tls-certificate FILE --tls-key FILE], all PEM",
    .options = std::vector<Option>{{"json", nullptr, "prints a line of JSON for each result"}}
        + sourceOptions(),
    .run = runEcho};

} // namespace app
