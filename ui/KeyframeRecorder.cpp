// SPDX-License-Identifier: Apache-2.0
#include "ui/KeyframeRecorder.h"

#include "ui/Workspace.h"
#include "ui/views/ImageView.h"

#include <QBuffer>

#include <chrono>

namespace ui {

namespace {

qint64 steadyMilliseconds()
{
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

QByteArray keyframePng(const QImage& picture)
{
    const QImage small = picture.scaled(
        KeyframeRecorder::pictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    small.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG");
    return png;
}

} // namespace

KeyframeRecorder::KeyframeRecorder(Workspace& workspace, ImageView& view)
    : QObject(&view)
    , m_workspace(workspace)
    , m_view(view)
    , m_clock(steadyMilliseconds)
{
    connect(&workspace, &Workspace::sessionChanged, this, &KeyframeRecorder::begin);
    connect(&workspace, &Workspace::sessionClosing, this, &KeyframeRecorder::close);
    connect(&workspace, &Workspace::documentChanged, this, &KeyframeRecorder::follow);
    connect(&view, &ImageView::qualityChanged, this, &KeyframeRecorder::look);
    begin();
}

KeyframeRecorder::~KeyframeRecorder() = default;

void KeyframeRecorder::begin()
{
    core::EditSession* session = m_workspace.session();
    m_rows = session ? session->history().rows().size() : 0;
    m_position = session ? session->history().position() : 0;
    m_any = session && !session->keyframes().empty();
    m_rowsAtLast = m_rows;
    m_timeAtLast = m_clock();
    m_lastKept = m_position; // closed at once, it needs no picture
    m_due = false;
    m_outdated = 0;
}

void KeyframeRecorder::follow(const core::DocumentChange& change)
{
    core::EditSession* session = m_workspace.session();
    if (!session || change.what != core::DocumentChange::What::History)
        return;
    const core::History& history = session->history();
    const bool committed = history.rows().size() > m_rows;
    const bool moved = history.position() != m_position;
    m_rows = history.rows().size();
    m_position = history.position();
    if (!moved)
        return;
    // A step of the document alone may leave the picture as it is; no new one would come then.
    const bool sameVoxels = committed && history.rows().back().statistics.bricks == 0;
    if (!sameVoxels)
        m_outdated = m_view.picture().cacheKey();
    m_due = m_due
        || (committed
            && (!m_any || m_rows - m_rowsAtLast >= std::size_t(stepsBetween)
                || m_clock() - m_timeAtLast >= millisecondsBetween));
    look();
}

bool KeyframeRecorder::showsPresentState() const
{
    return !m_view.picture().isNull() && m_view.picture().cacheKey() != m_outdated;
}

void KeyframeRecorder::look()
{
    const bool calm = m_view.quality() == gpu::Frame::Quality::Refined && showsPresentState();
    core::EditSession* session = m_workspace.session();
    if (!m_due || !calm || !session || session->transactionOpen())
        return;
    keep(m_position, m_view.picture());
}

void KeyframeRecorder::keep(core::RowId row, const QImage& picture)
{
    m_due = false;
    m_any = true;
    m_rowsAtLast = m_rows;
    m_timeAtLast = m_clock();
    m_lastKept = row;
    m_encoder.post([this, row, picture] {
        QByteArray png = keyframePng(picture);
        {
            const std::lock_guard lock(m_mutex);
            m_done.emplace_back(row, std::move(png));
        }
        QMetaObject::invokeMethod(this, &KeyframeRecorder::deliver, Qt::QueuedConnection);
    });
}

void KeyframeRecorder::deliver()
{
    std::vector<std::pair<core::RowId, QByteArray>> done;
    {
        const std::lock_guard lock(m_mutex);
        done.swap(m_done);
    }
    for (const auto& [row, png] : done) {
        if (core::EditSession* session = m_workspace.session())
            session->addKeyframe(row, png);
    }
}

void KeyframeRecorder::close()
{
    if (m_position != m_lastKept && m_position != 0 && showsPresentState())
        keep(m_position, m_view.picture());
    m_encoder.finish();
    deliver();
}

} // namespace ui
