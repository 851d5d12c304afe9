// SPDX-License-Identifier: Apache-2.0
#include "app/commands/pacs/SendCommand.h"

#include "app/steps/JsonLine.h"
#include "app/steps/SourceArguments.h"
#include "core/dicom/base/DicomFile.h"
#include "core/sources/PacsSource.h"

#include <QDirIterator>
#include <QFileInfo>
#include <QJsonArray>

#include <cstdio>

namespace app {

namespace {

/// The files of folders too, in the order of their names, but for those that are no DICOM.
/// @param others how many those are
QStringList filesOf(const QStringList& paths, int& others)
{
    QStringList all;
    for (const QString& path : paths) {
        if (!QFileInfo(path).isDir()) {
            all.append(path);
            continue;
        }
        QStringList inside;
        QDirIterator walk(path, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext())
            inside.append(walk.next());
        inside.sort();
        others += int(inside.removeIf([](const QString& file) {
            const auto opened = core::DicomFile::open(file);
            return !opened && opened.error().code == core::ErrorCode::UnsupportedFormat;
        }));
        all += inside;
    }
    return all;
}

int runSend(const Arguments& arguments)
{
    const core::Result<core::PacsSource> source = sourceOf(arguments);
    if (!source)
        return reportUsageError("send", sourceProblem(source.error()));
    const QStringList paths = arguments.rest().mid(1);
    if (paths.isEmpty())
        return reportUsageError("send", QStringLiteral("no files to send"));
    int others = 0;
    const QStringList files = filesOf(paths, others);
    // Only folders can have none; a file that is named is read.
    if (files.isEmpty())
        return reportFailure({core::ErrorCode::UnsupportedFormat,
            {paths.join(QStringLiteral(", ")), QStringLiteral("no file in it is a DICOM file")}});
    const core::Result<core::SentObjects> done = core::sendFiles(*source, files, core::Progress());
    if (!done)
        return reportFailure(done.error());
    if (others > 0)
        std::fprintf(stderr, "burin: files that are no DICOM stayed here: %d\n", others);
    for (const QString& warning : done->warnings)
        std::fprintf(stderr, "burin: %s\n", qUtf8Printable(warning));
    if (arguments.has("json")) {
        printJsonLine(
            {{QStringLiteral("node"), source->address()}, {QStringLiteral("sent"), done->sent},
                {QStringLiteral("warnings"), QJsonArray::fromStringList(done->warnings)}});
    } else {
        std::printf("%s took %d\n", qUtf8Printable(source->address()), done->sent);
    }
    return 0;
}

} // namespace

const Command sendCommand{.name = "send",
    .words = "SOURCE PATH...",
    .usage = "SOURCE PATH... [--json]",
    .summary = "stores DICOM files, or those of folders, at a source",
    .options = std::vector<Option>{{"json", nullptr, "prints a line of JSON for each result"}}
        + sourceOptions(),
    .run = runSend};

} // namespace app
