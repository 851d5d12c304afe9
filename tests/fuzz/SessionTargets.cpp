// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/FuzzTargets.h"

#include "core/delta/BrickDelta.h"
#include "core/delta/DeltaStream.h"
#include "core/refine/mesh/SurfaceDelta.h"
#include "core/session/surface/SurfaceStep.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/SessionPreview.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/records/SessionImages.h"

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
    (void)loadSessionImages(file.path());
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
    BrickDelta stream;
    stream.pieces.emplace_back(
        reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
    // Once more as what the stream holds, which no mutation of it would leave sound.
    DeltaWriter writer;
    writer.add(bytes);
    for (const BrickDelta& delta : {stream, BrickDelta{writer.finish()}}) {
        const Result<std::vector<BrickImage>> images = expandDelta(delta, {{40, 36, 34}});
        for (std::size_t i = 0; images && i < images->size(); ++i) {
            const BrickImage& image = (*images)[i];
            const int voxelBytes = bytesPerVoxel(image.key.field);
            if (image.bytes.size() != std::size_t(voxelBytes) * BrickGrid::voxelsPerBrick)
                qFatal("a brick without its bytes");
        }
    }
}

void fuzzSurfaceStep(FuzzBytes bytes)
{
    const QByteArray plain(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size()));
    const Result<SimplexMeshDelta> delta = unpackedSurfaceDelta(plain);
    if (delta && packed(*delta) != plain)
        qFatal("a surface's difference has two forms");
    // As a row has it: packed, which no mutation would leave sound.
    DeltaWriter writer;
    writer.add(surfaceStepMagic);
    writer.add(bytes);
    constexpr std::uint64_t voxels = 24 * 20 * 16;
    (void)unpackedSurfaceStep({writer.finish()}, voxels);
}

} // namespace test
