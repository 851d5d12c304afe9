// SPDX-License-Identifier: Apache-2.0
#include "ui/window/BookmarkMenu.h"

#include "ui/base/MenuText.h"

#include "core/edits/kinds/views/Bookmarks.h"
#include "ui/views/VolumeView.h"
#include "ui/workspace/Workspace.h"

#include <QInputDialog>
#include <QMenu>

#include <algorithm>

namespace ui {

namespace {

core::OrthographicView viewOf(const Camera& camera)
{
    return {.eyeLps = camera.eyeLps(),
        .targetLps = camera.targetLps,
        .up = camera.up,
        .heightMm = camera.heightMm};
}

/// What was kept lies on the grids of edits, so its axes are made right-angled again.
Camera cameraOf(const core::OrthographicView& view)
{
    Camera camera;
    camera.targetLps = view.targetLps;
    camera.towardsViewer = glm::normalize(view.eyeLps - view.targetLps);
    const glm::dvec3 right = glm::normalize(glm::cross(view.up, camera.towardsViewer));
    camera.up = glm::cross(camera.towardsViewer, right);
    camera.heightMm = view.heightMm;
    return camera;
}

} // namespace

BookmarkMenu::BookmarkMenu(Workspace& workspace, VolumeView& view, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_view(view)
{
}

void BookmarkMenu::ask()
{
    if (!m_workspace.session())
        return;
    bool accepted = false;
    const QString name = QInputDialog::getText(m_view.window(), tr("Bookmark this view"),
        tr("Name of the view"), QLineEdit::Normal, freeName(), &accepted)
                             .trimmed();
    if (accepted && !name.isEmpty())
        keep(name);
}

void BookmarkMenu::keep(const QString& name)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    core::AddBookmark edit;
    edit.name = name;
    edit.view = viewOf(m_view.camera());
    edit.crosshairLps = m_workspace.crosshairLps();
    if (const auto kept = session->apply(edit); !kept)
        m_workspace.fail(kept.error());
    else
        m_workspace.say(tr("Kept as '%1'; View > Bookmarks comes back to it").arg(name));
}

void BookmarkMenu::show(const core::CameraBookmark& bookmark)
{
    m_view.setCamera(cameraOf(bookmark.view));
    m_workspace.setCrosshairLps(bookmark.crosshairLps);
}

QString BookmarkMenu::freeName() const
{
    const core::Document document = m_workspace.session()->foreseenDocument();
    for (int number = document.lastBookmarkGiven() + 1;; ++number) {
        const QString name = tr("View %1").arg(number);
        const bool taken = std::any_of(document.bookmarks.begin(), document.bookmarks.end(),
            [&name](const core::CameraBookmark& bookmark) { return bookmark.name == name; });
        if (!taken)
            return name;
    }
}

void BookmarkMenu::fill(QMenu& menu)
{
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { list(menu); });
}

void BookmarkMenu::list(QMenu& menu)
{
    menu.clear();
    const core::EditSession* session = m_workspace.session();
    if (!session || session->document().bookmarks.empty()) {
        menu.addAction(tr("None yet: Ctrl+B keeps a view"))->setEnabled(false);
        return;
    }
    const auto shown = [](const core::CameraBookmark& bookmark) { return menuText(bookmark.name); };
    for (const core::CameraBookmark& bookmark : session->document().bookmarks)
        menu.addAction(shown(bookmark), this, [this, bookmark] { show(bookmark); });
    menu.addSeparator();
    QMenu* remove = menu.addMenu(tr("Remove"));
    for (const core::CameraBookmark& bookmark : session->document().bookmarks) {
        remove->addAction(shown(bookmark), this, [this, id = bookmark.id] {
            // The menu may have been open while the study was closed.
            core::EditSession* of = m_workspace.session();
            if (!of)
                return;
            if (const auto removed = of->apply(core::RemoveBookmark{.bookmark = id}); !removed)
                m_workspace.fail(removed.error());
        });
    }
}

} // namespace ui
