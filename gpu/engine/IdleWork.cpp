// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/IdleWork.h"

#include "core/base/Log.h"
#include "gpu/gl/GlFailure.h"

#include <algorithm>
#include <exception>

namespace gpu {

namespace {

constexpr std::size_t segmentationBricksPerSlice = 64;

} // namespace

IdleWork::IdleWork(EditPrograms& programs, FieldPrograms& fieldPrograms)
    : m_programs(programs)
    , m_fieldPrograms(fieldPrograms)
{
}

void IdleWork::warmUp(const glm::ivec3& volumeSize, KernelWarmUp::Of kernels)
{
    const std::pair asked(kernels, KernelWarmUp::sizeLike(volumeSize));
    if (std::find(m_warm.begin(), m_warm.end(), asked) != m_warm.end())
        return;
    m_warm.push_back(asked);
    m_warmUps.emplace_back(m_programs, m_fieldPrograms, asked.second, kernels);
}

bool IdleWork::doSome(VoxelFields* fields, bool editing)
{
    if (fields && fields->barriersStale()) {
        fields->updateBarriers();
        return true;
    }
    if (fields && fields->segmentationStale()) {
        fields->updateSegmentation(segmentationBricksPerSlice);
        return true;
    }
    if (fields && fields->piecesStale()) {
        fields->updatePieces(segmentationBricksPerSlice);
        return true;
    }
    // Not while a pen is down: what it needs compiles for it anyway.
    return !m_warmUps.empty() && !editing && warmUpMore();
}

bool IdleWork::warmUpMore()
{
    bool more = false;
    try {
        more = m_warmUps.front().runNext();
        requireNoError();
    } catch (const std::exception&) {
        qCDebug(core::log, "Kernels are not made ready: %s",
            qUtf8Printable(errorBeingHandled().arguments.join(QStringLiteral(": "))));
        more = false;
    }
    if (!more)
        m_warmUps.pop_front();
    return !m_warmUps.empty();
}

} // namespace gpu
