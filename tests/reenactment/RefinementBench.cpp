// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/RefinementBench.h"
#include "tests/support/scenes/PlainMasks.h"

#include "core/refine/fit/InitialFit.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/session/SessionChunks.h"
#include "core/session/SessionSurface.h"
#include "core/session/questions/VoxelQuestions.h"

#include <chrono>
#include <thread>

using namespace core;

namespace reenact {

RefinementBench::RefinementBench(LoadedVolume study, const Mask& mask)
    : m_geometry(study.volume.geometry)
{
    Result<std::unique_ptr<EditSession>> session =
        EditSession::create(m_engine, std::move(study), {});
    if (!session)
        qFatal("no session");
    m_session = *std::move(session);
    const Edit import = test::maskImport(QStringLiteral("poor.nrrd"), mask.size,
        {{QStringLiteral("Organ"), runsOf(mask), 0x4080C0}});
    if (const QString why = tried(import); !why.isEmpty())
        qFatal("%s", qPrintable(why));
}

QString RefinementBench::tried(const Edit& edit)
{
    Result<void> done = m_session->apply(edit);
    if (done)
        done = m_session->settle();
    return done ? QString() : done.error().arguments.join(QStringLiteral(": "));
}

QString RefinementBench::undone()
{
    Result<void> done = m_session->undo();
    if (done)
        done = m_session->settle();
    return done ? QString() : done.error().arguments.join(QStringLiteral(": "));
}

Mask RefinementBench::segment() const
{
    Mask mask{m_geometry.size, *m_session->questions().labels(0)};
    for (std::uint8_t& value : mask.values)
        value = value == 1 ? 1 : 0;
    return mask;
}

Mask RefinementBench::seen() const
{
    const SimplexMesh* surface = m_session->surface().mesh();
    if (!surface)
        return segment();
    const Result<VoxelRuns> inside = voxelsOf(*surface, m_geometry, {});
    return inside ? maskOf(*inside, m_geometry.size) : segment();
}

std::shared_ptr<const ChunkMap> RefinementBench::chunks()
{
    for (int tries = 0; tries < 60'000; ++tries) {
        if (auto map = m_session->chunks().map())
            return map;
        m_session->poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return nullptr;
}

Result<Truth> Truth::of(const Mask& organ, const VolumeGeometry& geometry, int vertices)
{
    const Result<SimplexMesh> mesh =
        initialFit(BoxMask::of(runsOf(organ), geometry.size), geometry, {.vertices = vertices}, {});
    if (!mesh)
        return tl::unexpected(mesh.error());
    const Result<VoxelRuns> inside = voxelsOf(*mesh, geometry, {});
    if (!inside)
        return tl::unexpected(inside.error());
    return Truth{.plain = organ, .voxelised = maskOf(*inside, geometry.size)};
}

double Truth::errorOf(const Mask& mask) const
{
    return 100.0 * double(differing(mask, voxelised)) / double(countOf(voxelised));
}

double Truth::plainErrorOf(const Mask& mask) const
{
    return 100.0 * double(differing(mask, plain)) / double(countOf(plain));
}

} // namespace reenact
