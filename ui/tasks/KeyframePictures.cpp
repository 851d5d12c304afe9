// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/KeyframePictures.h"

#include "core/base/OnMainThread.h"
#include "core/session/SessionKeyframes.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>
#include <cstdlib>

namespace ui {

namespace {

constexpr int kept = 64;

} // namespace

KeyframePictures::KeyframePictures(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_pictures(kept)
{
    connect(&workspace, &Workspace::sessionChanged, this, &KeyframePictures::forget);
    // The picture of a row may be replaced by a newer one.
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History && m_workspace.session())
                m_pictures.remove(m_workspace.session()->history().position());
        });
}

core::RowId KeyframePictures::nearest(const std::vector<core::RowId>& line, int lineIndex) const
{
    core::RowId found = -1;
    int distance = 0;
    core::EditSession* session = m_workspace.session();
    const std::vector<core::RowId> rows =
        session ? session->keyframes().rows() : std::vector<core::RowId>();
    for (int i = 0; i < int(line.size()); ++i) {
        const core::RowId row = line[std::size_t(i)];
        if (!std::binary_search(rows.begin(), rows.end(), row))
            continue;
        if (found < 0 || std::abs(i - lineIndex) < distance) {
            found = row;
            distance = std::abs(i - lineIndex);
        }
    }
    return found;
}

QImage KeyframePictures::picture(core::RowId row)
{
    if (const QImage* picture = m_pictures.object(row))
        return *picture;
    core::EditSession* session = m_workspace.session();
    if (!session || !m_asked.insert(row).second)
        return {};
    const auto deliver =
        core::onMainThread(this, [this, row, asked = m_session](const QImage& picture) {
            if (m_session == asked)
                take(row, picture);
        });
    session->keyframes().fetch(
        row, [deliver](const QByteArray& png) { deliver(QImage::fromData(png, "PNG")); });
    return {};
}

void KeyframePictures::take(core::RowId row, const QImage& picture)
{
    m_asked.erase(row);
    m_pictures.insert(row, new QImage(picture));
    Q_EMIT arrived(row);
}

void KeyframePictures::forget()
{
    ++m_session;
    m_pictures.clear();
    m_asked.clear();
}

} // namespace ui
