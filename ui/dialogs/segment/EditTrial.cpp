// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/EditTrial.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditTask.h"
#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QDialog>
#include <QPointer>

#include <utility>

namespace ui {

namespace {

constexpr int soonMilliseconds = 30;
constexpr int restMilliseconds = 300;
constexpr int laterMilliseconds = 200; ///< while a stroke is under the pen
constexpr int countMilliseconds = 150; ///< a handle that is dragged goes on sooner than this

} // namespace

EditTrial::EditTrial(Workspace& workspace, Pace pace, QWidget* owner)
    : QObject(owner)
    , m_workspace(workspace)
    , m_pace(pace)
{
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &EditTrial::begin);
    m_countSoon.setSingleShot(true);
    m_countSoon.setInterval(countMilliseconds);
    connect(&m_countSoon, &QTimer::timeout, this, &EditTrial::count);
    connect(&workspace, &Workspace::sessionClosing, this, &EditTrial::drop);
    if (const auto* dialog = qobject_cast<QDialog*>(owner))
        connect(dialog, &QDialog::finished, this, &EditTrial::drop);
}

bool EditTrial::isOpen() const
{
    const core::EditSession* session = m_workspace.session();
    const core::Edit* open = session ? session->openEdit() : nullptr;
    return m_shown && open && open->kind() == m_shown->kind();
}

bool EditTrial::isShown() const
{
    const core::EditSession* session = m_workspace.session();
    return isOpen() || (m_wanted && session && !session->transactionOpen());
}

/// Whether that edit is the one that is shown, or being worked out.
bool EditTrial::isOf(const core::Edit& edit) const
{
    return isOpen() && core::editToJson(*m_shown) == core::editToJson(edit);
}

std::optional<std::int64_t> EditTrial::voxels() const
{
    // Another edit may have taken the preview back; or it is about to be another one.
    return isOpen() && !m_wanted ? m_voxels : std::nullopt;
}

bool EditTrial::isCounting() const
{
    return m_wanted || (isOpen() && (m_countSoon.isActive() || m_reader));
}

void EditTrial::show(const core::Edit& edit)
{
    m_wanted = edit;
    if (m_pace != Pace::AtOnce) {
        // What is seen stays until there is something else to be seen.
        if (isOpen() && !m_workspace.session()->openHasBegun() && !isOf(edit))
            rollBack();
        m_soon.start(restMilliseconds);
    } else if (!m_soon.isActive()) {
        m_soon.start(soonMilliseconds);
    }
    Q_EMIT changed();
}

void EditTrial::begin()
{
    core::EditSession* session = m_workspace.session();
    if (!session || !m_wanted)
        return;
    // A growth or a stroke that stands open is left to its user; a preview is of this dialog or of
    // another one.
    const bool givesWay = m_pace == Pace::InPassing && !isOpen();
    if (givesWay && session->questions().isBeingRead())
        return m_soon.start(laterMilliseconds);
    if (session->transactionOpen() && (givesWay || !session->openIsReplaceable()))
        return m_soon.start(laterMilliseconds);
    const core::Edit wanted = *std::exchange(m_wanted, std::nullopt);
    if (!isOf(wanted)) {
        stopCounting();
        if (session->begin(wanted)) {
            m_shown = wanted;
            m_countSoon.start();
        } else {
            rollBack();
        }
    }
    Q_EMIT changed();
}

void EditTrial::count()
{
    const core::EditSession* session = m_workspace.session();
    const std::optional<int> label =
        isOpen() ? core::effectsOf(*m_shown).writesTo : std::optional<int>();
    const core::Segment* segment = label ? session->document().segment(*label) : nullptr;
    if (!segment) {
        Q_EMIT changed();
    } else if (!session->openHasBegun() || (m_hasBegun && session->growthProgress().running)) {
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
void EditTrial::awaitBegin()
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

void EditTrial::readOn()
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
        [reader = m_reader, label = std::uint8_t(*core::effectsOf(*m_shown).writesTo)] {
            return reader->voxelsOf(label);
        },
        [this](const core::Result<std::int64_t>& counted) {
            m_reader.reset();
            if (counted)
                m_voxels = *counted;
            Q_EMIT changed();
        });
}

void EditTrial::stopCounting()
{
    m_countSoon.stop();
    m_counting.cancel();
    m_reader.reset();
    m_voxels.reset();
    m_hasBegun = false;
}

void EditTrial::rollBack()
{
    stopCounting();
    if (isOpen())
        m_workspace.session()->end(core::Ending::Rollback);
    m_shown.reset();
}

void EditTrial::drop()
{
    if (!m_wanted && !m_shown)
        return;
    m_soon.stop();
    m_wanted.reset();
    rollBack();
    Q_EMIT changed();
}

bool EditTrial::handOver(const core::Edit& edit)
{
    m_soon.stop();
    m_wanted.reset();
    stopCounting();
    const bool isHandedOver = isOf(edit);
    m_shown.reset();
    return isHandedOver;
}

} // namespace ui
