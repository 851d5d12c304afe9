// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/delta/BrickDelta.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionPreview.h"
#include "core/sessionfile/SessionSalvage.h"

namespace test {

using namespace core;

void fuzzSession(FuzzBytes bytes)
{
    const ScratchFile file("file.burin", bytes);
    (void)previewSession(file.path());
    if (const Result<SessionContents> sound = checkSession(file.path())) {
        const QString target = file.path() + QStringLiteral("-repaired.burin");
        (void)salvageSession(file.path(), *sound, target);
        QFile::remove(target);
    }
    const auto session = SessionFile::open(file.path(), SessionAccess::SoundPart);
    if (!session)
        return;
    for (const HistoryRow& row : (*session)->contents().rows) {
        if (const Result<BrickDelta> delta = (*session)->readDelta(row.id))
            (void)expandDelta(*delta, {(*session)->contents().source.size});
    }
}

void fuzzDelta(FuzzBytes bytes)
{
    BrickDelta delta;
    delta.pieces.emplace_back(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
    (void)expandDelta(delta, {{40, 36, 34}});
}

} // namespace test
