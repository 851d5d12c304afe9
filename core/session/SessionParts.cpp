// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "core/session/SessionChunks.h"
#include "core/session/SessionDisplay.h"
#include "core/session/SessionKeyframes.h"
#include "core/session/SessionStorage.h"
#include "core/session/SessionSurface.h"
#include "core/session/StepFindings.h"
#include "core/session/operations/OperationQueue.h"
#include "core/session/questions/VoxelQuestions.h"

#include <utility>

namespace core {

struct EditSession::Parts {
    explicit Parts(OperationQueue& queue)
        : questions(queue, queue.state().document.volumes.front().geometry.size)
        , chunks(queue.state())
        , findings(queue.state())
        , surface(queue)
        , segmentWork(queue)
        , display(queue)
        , keyframes(queue.state())
        , storage(queue)
    {
    }
    VoxelQuestions questions;
    SessionChunks chunks;
    StepFindings findings;
    SessionSurface surface;
    SegmentWork segmentWork;
    SessionDisplay display;
    SessionKeyframes keyframes;
    SessionStorage storage;
};

EditSession::EditSession(std::unique_ptr<OperationQueue> queue)
    : m_parts(std::make_unique<Parts>(*queue))
    , m_queue(std::move(queue))
{
}

EditSession::~EditSession() = default;

VoxelQuestions& EditSession::questions()
{
    return m_parts->questions;
}

SessionChunks& EditSession::chunks()
{
    return m_parts->chunks;
}

const StepFindings& EditSession::findings() const
{
    return m_parts->findings;
}

SessionSurface& EditSession::surface()
{
    return m_parts->surface;
}

SegmentWork& EditSession::segmentWork()
{
    return m_parts->segmentWork;
}

SessionDisplay& EditSession::display()
{
    return m_parts->display;
}

SessionKeyframes& EditSession::keyframes()
{
    return m_parts->keyframes;
}

SessionStorage& EditSession::storage()
{
    return m_parts->storage;
}

} // namespace core
