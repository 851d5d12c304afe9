// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QMenu;

namespace core {
struct CameraBookmark;
}

namespace ui {

class VolumeView;
class Workspace;

/// Bookmarks of views: stores the 3D view and the crosshair under a name, as a step of undo, and
/// lists the stored ones. Going back to one is not a step.
class BookmarkMenu : public QObject {
    Q_OBJECT

public:
    BookmarkMenu(Workspace& workspace, VolumeView& view, QObject* parent = nullptr);

    /// Asks for a name and stores the present view.
    void ask();
    void keep(const QString& name);
    void show(const core::CameraBookmark& bookmark);
    /// Fills the menu with the present bookmarks whenever it opens.
    void fill(QMenu& menu);

private:
    void list(QMenu& menu);
    [[nodiscard]] QString freeName() const;

    Workspace& m_workspace;
    VolumeView& m_view;
};

} // namespace ui
