// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/ThresholdTrial.h"

#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <utility>

namespace ui {

namespace {

constexpr int soonMilliseconds = 30;
constexpr int laterMilliseconds = 200; ///< while a stroke is under the pen
constexpr int countMilliseconds = 150; ///< a handle that is dragged goes on sooner than this

} // namespace

ThresholdTrial::ThresholdTrial(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &ThresholdTrial::begin);
    m_countSoon.setSingleShot(true);
    m_countSoon.setInterval(countMilliseconds);
    connect(&m_countSoon, &QTimer::timeout, this, &ThresholdTrial::count);
    connect(&workspace, &Workspace::sessionClosing, this, &ThresholdTrial::drop);
}

bool ThresholdTrial::isOpen() const
{
    const core::EditSession* session = m_workspace.session();
    return m_shown && session && session->isOpen<core::ThresholdSegment>();
}

std::optional<std::int64_t> ThresholdTrial::voxels() const
{
    // Another edit may have taken the preview back; or it is about to be another one.
    return isOpen() && !m_wanted ? m_voxels : std::nullopt;
}

bool ThresholdTrial::isCounting() const
{
    return m_wanted || (isOpen() && (m_countSoon.isActive() || m_reader));
}

void ThresholdTrial::show(const core::ThresholdSegment& edit)
{
    m_wanted = edit;
    if (!m_soon.isActive())
        m_soon.start(soonMilliseconds);
    Q_EMIT changed();
}

void ThresholdTrial::begin()
{
    core::EditSession* session = m_workspace.session();
    if (!session || !m_wanted)
        return;
    // The one before is taken back by another one. A growth that stands open is left to its user.
    const bool isTaken = session->transactionOpen() && !session->isOpen<core::ThresholdSegment>();
    if (isTaken)
        return m_soon.start(laterMilliseconds);
    const core::ThresholdSegment wanted = *std::exchange(m_wanted, std::nullopt);
    if (!isOpen() || *m_shown != wanted) {
        m_shown.reset();
        stopCounting();
        if (session->begin(wanted)) {
            m_shown = wanted;
            m_countSoon.start();
        }
    }
    Q_EMIT changed();
}

void ThresholdTrial::count()
{
    const core::EditSession* session = m_workspace.session();
    const core::Segment* segment =
        isOpen() ? session->document().segment(m_shown->segment) : nullptr;
    if (!segment) {
        Q_EMIT changed();
    } else if (m_hasBegun && session->growthProgress().running) {
        m_countSoon.start();
    } else {
        m_reader = std::make_shared<core::LabelReader>(
            m_workspace.volume()->geometry.size, segment->plane);
        if (m_hasBegun)
            readOn();
        else
            awaitBegin();
    }
}

/// Large volumes are gone through in slices of time, and questions are answered in between. Whether
/// that is going on is known only when the engine has begun, which is when it answers a question.
void ThresholdTrial::awaitBegin()
{
    // One that has read nothing yet always has something to ask.
    static_cast<void>(m_workspace.session()->questions().readOn(
        m_reader, [self = QPointer(this), reader = m_reader](const core::Result<void>& portion) {
            if (!self || self->m_reader != reader)
                return;
            self->m_reader.reset();
            self->m_hasBegun = portion.has_value();
            if (portion)
                return self->count();
            self->stopCounting();
            Q_EMIT self->changed();
        }));
}

void ThresholdTrial::readOn()
{
    const bool isAsked = m_workspace.session()->questions().readOn(
        m_reader, [self = QPointer(this), reader = m_reader](const core::Result<void>& portion) {
            if (!self || self->m_reader != reader)
                return;
            if (portion && self->isOpen())
                return self->readOn();
            self->stopCounting();
            Q_EMIT self->changed();
        });
    if (isAsked)
        return;
    m_counting.replace(
        this,
        [reader = m_reader, label = m_shown->segment] {
            return reader->voxelsOf(std::uint8_t(label));
        },
        [this](const core::Result<std::int64_t>& counted) {
            m_reader.reset();
            if (counted)
                m_voxels = *counted;
            Q_EMIT changed();
        });
}

void ThresholdTrial::stopCounting()
{
    m_countSoon.stop();
    m_counting.cancel();
    m_reader.reset();
    m_voxels.reset();
    m_hasBegun = false;
}

void ThresholdTrial::drop()
{
    m_soon.stop();
    m_wanted.reset();
    stopCounting();
    if (isOpen())
        m_workspace.session()->end(core::Ending::Rollback);
    m_shown.reset();
    Q_EMIT changed();
}

void ThresholdTrial::take(const core::ThresholdSegment& edit)
{
    m_soon.stop();
    m_wanted.reset();
    stopCounting();
    const bool isShown = isOpen() && *m_shown == edit;
    m_shown.reset();
    takeThreshold(m_workspace, edit, isShown);
    Q_EMIT changed();
}

} // namespace ui
